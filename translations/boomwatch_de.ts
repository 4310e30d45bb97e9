<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Menus</name>
    <message>
        <source>&amp;Bag...</source>
        <translation>&amp;Bag...</translation>
    </message>
    <message>
        <source>&amp;Source</source>
        <translation>&amp;Quelle</translation>
    </message>
    <message>
        <source>&amp;Stereo recording...</source>
        <translation>&amp;Stereoaufnahme...</translation>
    </message>
    <message>
        <source>&amp;Point clouds...</source>
        <translation>&amp;Punktwolken...</translation>
    </message>
    <message>
        <source>&amp;Depth recording...</source>
        <translation>&amp;Tiefenaufnahme...</translation>
    </message>
    <message>
        <source>&amp;Camera...</source>
        <translation>&amp;Kamera...</translation>
    </message>
    <message>
        <source>Demo: slanted &amp;floor</source>
        <translation>Demo: schräger &amp;Boden</translation>
    </message>
    <message>
        <source>Demo: four c&amp;ylinders</source>
        <translation>Demo: vier &amp;Zylinder</translation>
    </message>
    <message>
        <source>Demo: &amp;wall</source>
        <translation>Demo: &amp;Wand</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>B&amp;eenden</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Cloud coloured by</source>
        <translation>&amp;Wolke gefärbt nach</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>Tiefe</translation>
    </message>
    <message>
        <source>Height</source>
        <translation>Höhe</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>&amp;Maps coloured in</source>
        <translation>&amp;Karten gefärbt in</translation>
    </message>
    <message>
        <source>Grey</source>
        <translation>Grau</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>&amp;Reset 3-D view</source>
        <translation>3-D-Ansicht &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>&amp;Fit the maps</source>
        <translation>Karten &amp;einpassen</translation>
    </message>
    <message>
        <source>&amp;Light theme</source>
        <translation>&amp;Helle Darstellung</translation>
    </message>
    <message>
        <source>Reset la&amp;yout</source>
        <translation>An&amp;ordnung zurücksetzen</translation>
    </message>
    <message>
        <source>S&amp;napshot</source>
        <translation>&amp;Bild speichern</translation>
    </message>
    <message>
        <source>Save a picture of the whole window (Ctrl+S)</source>
        <translation>Ein Bild des ganzen Fensters speichern (Strg+S)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Demo: forestry y&amp;ard</source>
        <translation>Demo: &amp;Holzplatz</translation>
    </message>
    <message>
        <source>&amp;Map...</source>
        <translation>&amp;Karte...</translation>
    </message>
</context>
<context>
    <name>Panes</name>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Probability map</source>
        <translation>Wahrscheinlichkeitskarte</translation>
    </message>
    <message>
        <source>Environment model</source>
        <translation>Umgebungsmodell</translation>
    </message>
    <message>
        <source>Distance against time</source>
        <translation>Abstand über der Zeit</translation>
    </message>
</context>
<context>
    <name>Parameters</name>
    <message>
        <source>cells</source>
        <translation>Zellen</translation>
    </message>
    <message>
        <source>points</source>
        <translation>Punkte</translation>
    </message>
    <message>
        <source>frames</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Bounds</source>
        <translation>Grenzen</translation>
    </message>
    <message>
        <source>Cell depth</source>
        <translation>Zelltiefe</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Abstandssuche</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Mitte z</translation>
    </message>
    <message>
        <source>Size x</source>
        <translation>Größe x</translation>
    </message>
    <message>
        <source>Size y</source>
        <translation>Größe y</translation>
    </message>
    <message>
        <source>Size z</source>
        <translation>Größe z</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>Neighbour radius</source>
        <translation>Nachbarradius</translation>
    </message>
    <message>
        <source>Cluster tolerance</source>
        <translation>Gruppenabstand</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Block size</source>
        <translation>Blockgröße</translation>
    </message>
    <message>
        <source>Uniqueness</source>
        <translation>Eindeutigkeit</translation>
    </message>
    <message>
        <source>Prefilter cap</source>
        <translation>Vorfiltergrenze</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>Gültigkeit</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>Release delay</source>
        <translation>Rückfallverzögerung</translation>
    </message>
    <message>
        <source>Tracking</source>
        <translation>Verfolgung</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Verfolger</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>Werkzeugpunkt</translation>
    </message>
    <message>
        <source>Tool acceleration</source>
        <translation>Werkzeugbeschleunigung</translation>
    </message>
    <message>
        <source>Leave threshold</source>
        <translation>Austrittsschwelle</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Lernzeit</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Boom</source>
        <translation>Ausleger</translation>
    </message>
    <message>
        <source>pixels</source>
        <translation>Pixel</translation>
    </message>
    <message>
        <source>x minimum (left)</source>
        <translation>x-Minimum (links)</translation>
    </message>
    <message>
        <source>Left limit of the watched space.</source>
        <translation>Linke Grenze des überwachten Raums.</translation>
    </message>
    <message>
        <source>x maximum (right)</source>
        <translation>x-Maximum (rechts)</translation>
    </message>
    <message>
        <source>Right limit of the watched space.</source>
        <translation>Rechte Grenze des überwachten Raums.</translation>
    </message>
    <message>
        <source>y minimum (top)</source>
        <translation>y-Minimum (oben)</translation>
    </message>
    <message>
        <source>Upper limit of the watched space; y points down.</source>
        <translation>Obere Grenze des überwachten Raums; y zeigt nach unten.</translation>
    </message>
    <message>
        <source>y maximum (bottom)</source>
        <translation>y-Maximum (unten)</translation>
    </message>
    <message>
        <source>Lower limit of the watched space; y points down.</source>
        <translation>Untere Grenze des überwachten Raums; y zeigt nach unten.</translation>
    </message>
    <message>
        <source>z minimum (near)</source>
        <translation>z-Minimum (nah)</translation>
    </message>
    <message>
        <source>Minimum depth of the watched space. Nearer points are ignored.</source>
        <translation>Kleinste Tiefe des überwachten Raums. Nähere Punkte werden ignoriert.</translation>
    </message>
    <message>
        <source>z maximum (far)</source>
        <translation>z-Maximum (fern)</translation>
    </message>
    <message>
        <source>Maximum depth of the watched space. Points farther away are ignored.</source>
        <translation>Größte Tiefe des überwachten Raums. Fernere Punkte werden ignoriert.</translation>
    </message>
    <message>
        <source>Environment model</source>
        <translation>Umgebungsmodell</translation>
    </message>
    <message>
        <source>Cell size (resolution)</source>
        <translation>Zellgröße (resolution)</translation>
    </message>
    <message>
        <source>Side of a cell of the environment model. A higher value is faster but coarser. Usual: 0.02 to 0.1 m.</source>
        <translation>Seitenlänge einer Zelle des Umgebungsmodells. Ein höherer Wert rechnet schneller, aber gröber. Üblich: 0,02 bis 0,1 m.</translation>
    </message>
    <message>
        <source>parallel: cells are columns along z, as in the thesis. perspective: cells are image rays, without gaps behind near objects; resolution is then the cell size at half of z_max.</source>
        <translation>parallel: Zellen sind Säulen entlang z, wie in der Masterarbeit. perspective: Zellen sind Bildstrahlen, ohne Lücken hinter nahen Objekten; resolution ist dann die Zellgröße bei halbem z_max.</translation>
    </message>
    <message>
        <source>surface: mean depth of the surface in the cell. nearest: depth of the nearest point, up to half a cell too near on slanted surfaces.</source>
        <translation>surface: mittlere Tiefe der Fläche in der Zelle. nearest: Tiefe des nächsten Punktes, auf schrägen Flächen bis zu einer halben Zelle zu nah.</translation>
    </message>
    <message>
        <source>Probability threshold (probtresh)</source>
        <translation>Schwelle (probtresh)</translation>
    </message>
    <message>
        <source>A cell enters the model when its probability exceeds this. With a higher value objects enter later and less noise enters. Usual: 0.3 to 0.6.</source>
        <translation>Eine Zelle gelangt ins Modell, wenn ihre Wahrscheinlichkeit diesen Wert überschreitet. Bei einem höheren Wert kommen Objekte später ins Modell und weniger Rauschen. Üblich: 0,3 bis 0,6.</translation>
    </message>
    <message>
        <source>Hit weight (p_prior)</source>
        <translation>Treffergewicht (p_prior)</translation>
    </message>
    <message>
        <source>Probability that each hit adds to a cell. With a higher value objects enter the model sooner. Not used by log_odds. Usual: 0.1 to 0.3.</source>
        <translation>Wahrscheinlichkeit, die jeder Treffer einer Zelle hinzufügt. Bei einem höheren Wert kommen Objekte früher ins Modell. Von log_odds nicht verwendet. Üblich: 0,1 bis 0,3.</translation>
    </message>
    <message>
        <source>Decay factor (p_post)</source>
        <translation>Abklingfaktor (p_post)</translation>
    </message>
    <message>
        <source>Share of its probability that a cell keeps after each frame. With a higher value objects stay longer. Not used by log_odds. Usual: 0.6 to 0.9.</source>
        <translation>Anteil der Wahrscheinlichkeit, den eine Zelle nach jedem Bild behält. Bei einem höheren Wert bleiben Objekte länger. Von log_odds nicht verwendet. Üblich: 0,6 bis 0,9.</translation>
    </message>
    <message>
        <source>Update rule</source>
        <translation>Aktualisierung</translation>
    </message>
    <message>
        <source>hysteresis: a cell stays until its probability falls to leave_threshold. thesis: a single miss can remove a cell. log_odds: Bayes&apos; rule.</source>
        <translation>hysteresis: Eine Zelle bleibt, bis ihre Wahrscheinlichkeit auf leave_threshold sinkt. thesis: Ein einziger Fehltreffer kann eine Zelle entfernen. log_odds: Satz von Bayes.</translation>
    </message>
    <message>
        <source>hysteresis: a cell leaves the model at this probability. With a higher value objects leave sooner. It must be below probtresh. Usual: 0.05 to 0.3.</source>
        <translation>hysteresis: Bei dieser Wahrscheinlichkeit verlässt eine Zelle das Modell. Bei einem höheren Wert gehen Objekte früher. Der Wert muss unter probtresh liegen. Üblich: 0,05 bis 0,3.</translation>
    </message>
    <message>
        <source>Log-odds hit</source>
        <translation>Log-Odds Treffer</translation>
    </message>
    <message>
        <source>log_odds: probability of a cell after one hit. With a higher value objects enter the model sooner. Usual: 0.6 to 0.8.</source>
        <translation>log_odds: Wahrscheinlichkeit einer Zelle nach einem Treffer. Bei einem höheren Wert kommen Objekte früher ins Modell. Üblich: 0,6 bis 0,8.</translation>
    </message>
    <message>
        <source>Log-odds miss</source>
        <translation>Log-Odds Fehltreffer</translation>
    </message>
    <message>
        <source>log_odds: probability of a cell after one miss. With a higher value objects stay longer. Usual: 0.35 to 0.45.</source>
        <translation>log_odds: Wahrscheinlichkeit einer Zelle nach einem Fehltreffer. Bei einem höheren Wert bleiben Objekte länger. Üblich: 0,35 bis 0,45.</translation>
    </message>
    <message>
        <source>Log-odds minimum</source>
        <translation>Log-Odds Minimum</translation>
    </message>
    <message>
        <source>log_odds: minimum probability from which a hit counts up. With a higher value objects enter the model sooner. Usual: 0.1 to 0.2.</source>
        <translation>log_odds: kleinste Wahrscheinlichkeit, von der aus ein Treffer weiterzählt. Bei einem höheren Wert kommen Objekte früher ins Modell. Üblich: 0,1 bis 0,2.</translation>
    </message>
    <message>
        <source>Log-odds maximum</source>
        <translation>Log-Odds Maximum</translation>
    </message>
    <message>
        <source>log_odds: maximum probability that hits lead to. With a higher value objects stay longer. Usual: 0.9 to 0.98.</source>
        <translation>log_odds: größte Wahrscheinlichkeit, zu der Treffer führen. Bei einem höheren Wert bleiben Objekte länger. Üblich: 0,9 bis 0,98.</translation>
    </message>
    <message>
        <source>Maximum memory of the environment model. Settings that need more are rejected.</source>
        <translation>Größter Speicher für das Umgebungsmodell. Einstellungen, die mehr brauchen, werden abgelehnt.</translation>
    </message>
    <message>
        <source>Search method</source>
        <translation>Suchverfahren</translation>
    </message>
    <message>
        <source>exact: searches every cell. rays: search rays of the thesis, which miss objects between two rays.</source>
        <translation>exact: durchsucht jede Zelle. rays: Suchstrahlen der Masterarbeit, die Objekte zwischen zwei Strahlen übersehen.</translation>
    </message>
    <message>
        <source>Ray spacing (interval)</source>
        <translation>Strahlabstand (interval)</translation>
    </message>
    <message>
        <source>rays: cells between two search rays. A higher value is faster but misses more. Usual: 5 to 10 cells.</source>
        <translation>rays: Zellen zwischen zwei Suchstrahlen. Ein höherer Wert rechnet schneller, übersieht aber mehr. Üblich: 5 bis 10 Zellen.</translation>
    </message>
    <message>
        <source>Ray length (radius)</source>
        <translation>Strahllänge (radius)</translation>
    </message>
    <message>
        <source>rays: length of a search ray. A higher value finds objects farther away and takes longer. Rays must reach the caution distance. Usual: 50 to 100 cells.</source>
        <translation>rays: Länge eines Suchstrahls. Ein höherer Wert findet fernere Objekte und dauert länger. Die Strahlen müssen bis zum Vorsichtsabstand reichen. Üblich: 50 bis 100 Zellen.</translation>
    </message>
    <message>
        <source>Search range</source>
        <translation>Suchreichweite</translation>
    </message>
    <message>
        <source>exact: how far from the load obstacles are searched. It must not be less than the caution distance. Usual: 5 to 20 m.</source>
        <translation>exact: wie weit um die Last nach Hindernissen gesucht wird. Der Wert darf nicht kleiner sein als der Vorsichtsabstand. Üblich: 5 bis 20 m.</translation>
    </message>
    <message>
        <source>Unobserved space</source>
        <translation>Unbeobachteter Raum</translation>
    </message>
    <message>
        <source>show: the window shows the unobserved share, and there is no distance where too little was observed (min_observed). ignore: treats unobserved space as free, as in the thesis. solid: treats it as an obstacle.</source>
        <translation>show: Das Fenster zeigt den unbeobachteten Anteil; wo zu wenig beobachtet wurde (min_observed), gibt es keinen Abstand. ignore: behandelt unbeobachteten Raum als frei, wie in der Masterarbeit. solid: behandelt ihn als Hindernis.</translation>
    </message>
    <message>
        <source>Minimum object size</source>
        <translation>Kleinste Objektgröße</translation>
    </message>
    <message>
        <source>Objects smaller than this from corner to corner are drawn but ignored. A higher value ignores more objects. 0: off. Usual: 0.05 to 0.3 m.</source>
        <translation>Objekte, die von Ecke zu Ecke kleiner sind, werden gezeichnet, aber ignoriert. Ein höherer Wert ignoriert mehr Objekte. 0: aus. Üblich: 0,05 bis 0,3 m.</translation>
    </message>
    <message>
        <source>Confirm objects below</source>
        <translation>Objekte bestätigen unter</translation>
    </message>
    <message>
        <source>Objects smaller than this, from corner to corner or in area, are ignored until nearly every frame of a while has shown them, unlike a falling leaf. A higher value reports more objects late. 0: off. Usual: 0.2 to 0.5 m.</source>
        <translation>Objekte, die von Ecke zu Ecke oder als Fläche kleiner sind, werden ignoriert, bis eine Weile fast jedes Bild sie gezeigt hat, anders als ein fallendes Blatt. Ein höherer Wert meldet mehr Objekte spät. 0: aus. Üblich: 0,2 bis 0,5 m.</translation>
    </message>
    <message>
        <source>Watched parts</source>
        <translation>Überwachte Teile</translation>
    </message>
    <message>
        <source>Measure the distance from the load.</source>
        <translation>Den Abstand von der Last messen.</translation>
    </message>
    <message>
        <source>Measure the distance from the tracked tool.</source>
        <translation>Den Abstand vom verfolgten Werkzeug messen.</translation>
    </message>
    <message>
        <source>Measure the distance from the visible segments of the boom.</source>
        <translation>Den Abstand von den sichtbaren Abschnitten des Auslegers messen.</translation>
    </message>
    <message>
        <source>Caution distance</source>
        <translation>Vorsichtsabstand</translation>
    </message>
    <message>
        <source>At this distance the caution level begins and the bar begins to fill. A higher value warns earlier. Usual: 1 to 5 m.</source>
        <translation>Bei diesem Abstand beginnt die Stufe Vorsicht, und der Balken beginnt sich zu füllen. Ein höherer Wert warnt früher. Üblich: 1 bis 5 m.</translation>
    </message>
    <message>
        <source>Warning distance</source>
        <translation>Warnabstand</translation>
    </message>
    <message>
        <source>At this distance the warning level begins. A higher value warns earlier. Usual: 0.5 to 2 m.</source>
        <translation>Bei diesem Abstand beginnt die Stufe Warnung. Ein höherer Wert warnt früher. Üblich: 0,5 bis 2 m.</translation>
    </message>
    <message>
        <source>Caution time to contact</source>
        <translation>Vorsicht: Zeit bis Berührung</translation>
    </message>
    <message>
        <source>Caution also begins when the moving load would touch an obstacle within this time. A higher value warns earlier. 0: off. Usual: 1 to 4 s.</source>
        <translation>Vorsicht beginnt auch, wenn die bewegte Last innerhalb dieser Zeit ein Hindernis berühren würde. Ein höherer Wert warnt früher. 0: aus. Üblich: 1 bis 4 s.</translation>
    </message>
    <message>
        <source>Warning time to contact</source>
        <translation>Warnung: Zeit bis Berührung</translation>
    </message>
    <message>
        <source>The warning also begins when the moving load would touch an obstacle within this time. A higher value warns earlier. 0: off. Usual: 0.5 to 2 s.</source>
        <translation>Die Warnung beginnt auch, wenn die bewegte Last innerhalb dieser Zeit ein Hindernis berühren würde. Ein höherer Wert warnt früher. 0: aus. Üblich: 0,5 bis 2 s.</translation>
    </message>
    <message>
        <source>A level ends this much farther away than it begins. With a higher value levels flicker less. Usual: 0.02 to 0.2 m.</source>
        <translation>Eine Stufe endet um diesen Wert weiter entfernt, als sie beginnt. Bei einem höheren Wert flackern die Stufen weniger. Üblich: 0,02 bis 0,2 m.</translation>
    </message>
    <message>
        <source>How long a lower level must hold before the window shows it. With a higher value levels change less often. A load that moves away is released at once. Usual: 0.3 to 1 s.</source>
        <translation>Wie lange eine niedrigere Stufe gelten muss, bevor das Fenster sie zeigt. Bei einem höheren Wert wechseln die Stufen seltener. Für eine Last, die sich entfernt, gilt keine Verzögerung. Üblich: 0,3 bis 1 s.</translation>
    </message>
    <message>
        <source>Load source</source>
        <translation>Herkunft der Last</translation>
    </message>
    <message>
        <source>auto: detected when a tool is tracked or the source gives one, otherwise from the source. scene: only from the source. manual: the values below. detected: found at the tool in every frame.</source>
        <translation>auto: erkannt, wenn ein Werkzeug verfolgt wird oder die Quelle eines angibt, sonst aus der Quelle. scene: nur aus der Quelle. manual: die Werte unten. detected: in jedem Bild am Werkzeug gefunden.</translation>
    </message>
    <message>
        <source>Centre of the load, to the right of the camera.</source>
        <translation>Mitte der Last, rechts von der Kamera.</translation>
    </message>
    <message>
        <source>Centre of the load, below the camera.</source>
        <translation>Mitte der Last, unterhalb der Kamera.</translation>
    </message>
    <message>
        <source>Centre of the load, in front of the camera.</source>
        <translation>Mitte der Last, vor der Kamera.</translation>
    </message>
    <message>
        <source>Full size along the x axis of the load; of a log its length.</source>
        <translation>Volle Größe entlang der x-Achse der Last; bei einem Stamm die Länge.</translation>
    </message>
    <message>
        <source>Full size along the y axis of the load.</source>
        <translation>Volle Größe entlang der y-Achse der Last.</translation>
    </message>
    <message>
        <source>Full size along the z axis of the load.</source>
        <translation>Volle Größe entlang der z-Achse der Last.</translation>
    </message>
    <message>
        <source>First rotation, about y.</source>
        <translation>Erste Drehung, um y.</translation>
    </message>
    <message>
        <source>Second rotation, about x.</source>
        <translation>Zweite Drehung, um x.</translation>
    </message>
    <message>
        <source>Third rotation, about z.</source>
        <translation>Dritte Drehung, um z.</translation>
    </message>
    <message>
        <source>Shape of a detected load. cylinder: a log. box: a box. auto: a log, or a box where no log fits.</source>
        <translation>Form einer erkannten Last. cylinder: ein Stamm. box: ein Kasten. auto: ein Stamm, oder ein Kasten, wo kein Stamm passt.</translation>
    </message>
    <message>
        <source>Dimensions</source>
        <translation>Abmessungen</translation>
    </message>
    <message>
        <source>Sizes of a detected load. learnt: learnt at first, then improved by frames that show them better. locked: the sizes above.</source>
        <translation>Größen einer erkannten Last. learnt: anfangs gelernt, dann durch Bilder verbessert, die sie besser zeigen. locked: die Größen oben.</translation>
    </message>
    <message>
        <source>How long the sizes of a detected load are learnt. With a higher value more frames are averaged. Usual: 1 to 5 s.</source>
        <translation>Wie lange die Größen einer erkannten Last gelernt werden. Bei einem höheren Wert wird über mehr Bilder gemittelt. Üblich: 1 bis 5 s.</translation>
    </message>
    <message>
        <source>Maximum load size</source>
        <translation>Maximale Lastgröße</translation>
    </message>
    <message>
        <source>A longer body at the tool is rejected as load. With a higher value longer loads are detected. Set it somewhat above the longest load. Usual: 2 to 10 m.</source>
        <translation>Ein längerer Körper am Werkzeug wird als Last abgelehnt. Bei einem höheren Wert werden längere Lasten erkannt. Etwas größer wählen als die längste Last. Üblich: 2 bis 10 m.</translation>
    </message>
    <message>
        <source>Tool diameter</source>
        <translation>Werkzeugdurchmesser</translation>
    </message>
    <message>
        <source>Points within half of this of the tool point belong to the tool, not to the load. With a higher value more points belong to the tool. Usual: 0.3 to 1.5 m.</source>
        <translation>Punkte, die vom Werkzeugpunkt weniger als die Hälfte entfernt sind, gehören zum Werkzeug, nicht zur Last. Bei einem höheren Wert gehören mehr Punkte zum Werkzeug. Üblich: 0,3 bis 1,5 m.</translation>
    </message>
    <message>
        <source>Mask margin</source>
        <translation>Maskenrand</translation>
    </message>
    <message>
        <source>Points this close to a detected load are masked with it. With a higher value more points are masked. Any other load has a margin of one cell. Usual: 0.05 to 0.2 m.</source>
        <translation>Punkte, die einer erkannten Last so nah sind, werden mit ihr maskiert. Bei einem höheren Wert werden mehr Punkte maskiert. Jede andere Last hat einen Rand von einer Zelle. Üblich: 0,05 bis 0,2 m.</translation>
    </message>
    <message>
        <source>tld: learns, re-detects the tool and can be saved. cmt: tracks rotation and changes of size. csrt: accurate and slow, no re-detection. klt: fast, no re-detection. manual: the clicked pixel stays.</source>
        <translation>tld: lernt, erkennt das Werkzeug wieder und kann gespeichert werden. cmt: verfolgt Drehung und Größenänderung. csrt: genau und langsam, ohne Wiedererkennung. klt: schnell, ohne Wiedererkennung. manual: Der angeklickte Bildpunkt bleibt.</translation>
    </message>
    <message>
        <source>tld: learn new views of the tool while tracking. Off: use only the views learnt so far.</source>
        <translation>tld: beim Verfolgen neue Ansichten des Werkzeugs lernen. Aus: nur die bisher gelernten Ansichten verwenden.</translation>
    </message>
    <message>
        <source>right: the measured pixel at the centre of the box, or the next one to its right. near: a near point in the middle of the box, for a grapple with gaps.</source>
        <translation>right: der gemessene Bildpunkt in der Mitte des Rahmens oder der nächste rechts davon. near: ein naher Punkt in der Mitte des Rahmens, für einen Greifer mit Lücken.</translation>
    </message>
    <message>
        <source>Maximum tool age</source>
        <translation>Maximales Werkzeugalter</translation>
    </message>
    <message>
        <source>How long the tool may be out of sight. Until then its position is extrapolated; after that no distance is shown. Usual: 0.3 to 1 s.</source>
        <translation>Wie lange das Werkzeug außer Sicht sein darf. Bis dahin wird seine Position extrapoliert; danach wird kein Abstand angezeigt. Üblich: 0,3 bis 1 s.</translation>
    </message>
    <message>
        <source>Tool point noise</source>
        <translation>Rauschen des Werkzeugpunkts</translation>
    </message>
    <message>
        <source>Standard deviation of the measured tool point. A higher value smooths more and reacts later. Usual: 0.02 to 0.1 m.</source>
        <translation>Standardabweichung des gemessenen Werkzeugpunkts. Ein höherer Wert glättet mehr und reagiert später. Üblich: 0,02 bis 0,1 m.</translation>
    </message>
    <message>
        <source>How quickly the tool may change its velocity. A higher value smooths less and reacts sooner. Usual: 1 to 5 m/s².</source>
        <translation>Wie schnell das Werkzeug seine Geschwindigkeit ändern darf. Ein höherer Wert glättet weniger und reagiert früher. Üblich: 1 bis 5 m/s².</translation>
    </message>
    <message>
        <source>Maximum tool speed</source>
        <translation>Maximale Werkzeuggeschwindigkeit</translation>
    </message>
    <message>
        <source>Maximum speed of the tool. A tracker that jumps farther is rejected and must re-detect the tool. A higher value rejects fewer jumps. Usual: 3 to 10 m/s.</source>
        <translation>Größte Geschwindigkeit des Werkzeugs. Ein Verfolger, der weiter springt, wird verworfen und muss das Werkzeug wiedererkennen. Ein höherer Wert verwirft weniger Sprünge. Üblich: 3 bis 10 m/s.</translation>
    </message>
    <message>
        <source>Fixed depth (z_reprojection)</source>
        <translation>Feste Tiefe (z_reprojection)</translation>
    </message>
    <message>
        <source>Moves every kept point to this z. off: points keep their depth.</source>
        <translation>Verschiebt jeden behaltenen Punkt auf dieses z. off: Punkte behalten ihre Tiefe.</translation>
    </message>
    <message>
        <source>Outlier removal (low_pass)</source>
        <translation>Ausreißer entfernen (low_pass)</translation>
    </message>
    <message>
        <source>Removes isolated points from the cloud. Slow.</source>
        <translation>Entfernt vereinzelte Punkte aus der Wolke. Langsam.</translation>
    </message>
    <message>
        <source>Outlier method</source>
        <translation>Ausreißerverfahren</translation>
    </message>
    <message>
        <source>statistical: removes points that are unusually far from their neighbours. radius: removes points with too few neighbours.</source>
        <translation>statistical: entfernt Punkte, die ungewöhnlich weit von ihren Nachbarn entfernt sind. radius: entfernt Punkte mit zu wenigen Nachbarn.</translation>
    </message>
    <message>
        <source>Number of neighbours</source>
        <translation>Anzahl Nachbarn</translation>
    </message>
    <message>
        <source>statistical: nearest neighbours that each point is compared with. A higher value judges a larger area and is slower. Usual: 8 to 50.</source>
        <translation>statistical: nächste Nachbarn, mit denen jeder Punkt verglichen wird. Ein höherer Wert beurteilt eine größere Umgebung und dauert länger. Üblich: 8 bis 50.</translation>
    </message>
    <message>
        <source>Allowed deviations</source>
        <translation>Erlaubte Abweichungen</translation>
    </message>
    <message>
        <source>statistical: standard deviations above the mean distance at which a point is removed. A higher value removes fewer points. Usual: 1 to 3.</source>
        <translation>statistical: Standardabweichungen über dem mittleren Abstand, ab denen ein Punkt entfernt wird. Ein höherer Wert entfernt weniger Punkte. Üblich: 1 bis 3.</translation>
    </message>
    <message>
        <source>radius: how far a neighbour may be from a point. A higher value removes fewer points. Usual: 0.05 to 0.3 m.</source>
        <translation>radius: wie weit ein Nachbar von einem Punkt entfernt sein darf. Ein höherer Wert entfernt weniger Punkte. Üblich: 0,05 bis 0,3 m.</translation>
    </message>
    <message>
        <source>Minimum neighbours</source>
        <translation>Mindestzahl Nachbarn</translation>
    </message>
    <message>
        <source>radius: neighbours that a point needs. A higher value removes more points. Usual: 2 to 10.</source>
        <translation>radius: Nachbarn, die ein Punkt braucht. Ein höherer Wert entfernt mehr Punkte. Üblich: 2 bis 10.</translation>
    </message>
    <message>
        <source>Points closer together than this form one cluster. With a higher value more objects join, such as tool and ground. Usual: 0.05 to 0.2 m.</source>
        <translation>Punkte, die näher beieinander liegen, bilden eine Gruppe. Bei einem höheren Wert verbinden sich mehr Objekte, etwa Werkzeug und Boden. Üblich: 0,05 bis 0,2 m.</translation>
    </message>
    <message>
        <source>Depth smoothing</source>
        <translation>Tiefenglättung</translation>
    </message>
    <message>
        <source>Width of the window that averages noisy depth of a depth camera or a recorded cloud. A higher value smooths more. Below 3: off. Usual: 3 to 9 pixels.</source>
        <translation>Breite des Fensters, das verrauschte Tiefe einer Tiefenkamera oder einer aufgezeichneten Wolke mittelt. Ein höherer Wert glättet mehr. Unter 3: aus. Üblich: 3 bis 9 Pixel.</translation>
    </message>
    <message>
        <source>Minimum cluster size</source>
        <translation>Minimale Gruppengröße</translation>
    </message>
    <message>
        <source>Clusters with fewer points are removed as noise. A higher value removes more noise but also small objects. Usual: 10 to 50 points.</source>
        <translation>Gruppen mit weniger Punkten werden als Rauschen entfernt. Ein höherer Wert entfernt mehr Rauschen, aber auch kleine Objekte. Üblich: 10 bis 50 Punkte.</translation>
    </message>
    <message>
        <source>Stereo matcher</source>
        <translation>Stereozuordnung</translation>
    </message>
    <message>
        <source>sgbm: semi-global matching, dense. bm: block matching, faster but sparser.</source>
        <translation>sgbm: semiglobale Zuordnung, dicht. bm: Blockvergleich, schneller, aber lückenhafter.</translation>
    </message>
    <message>
        <source>Minimum disparity</source>
        <translation>Minimale Disparität</translation>
    </message>
    <message>
        <source>Disparity at which the search begins. With a higher value distant objects are ignored. Usual: 0 px.</source>
        <translation>Disparität, bei der die Suche beginnt. Bei einem höheren Wert werden ferne Objekte ignoriert. Üblich: 0 px.</translation>
    </message>
    <message>
        <source>Number of disparities</source>
        <translation>Anzahl Disparitäten</translation>
    </message>
    <message>
        <source>Disparities that are searched, a multiple of 16. A higher value measures nearer objects and takes longer. Usual: 64 to 256 px.</source>
        <translation>Durchsuchte Disparitäten, ein Vielfaches von 16. Ein höherer Wert misst nähere Objekte und dauert länger. Üblich: 64 bis 256 px.</translation>
    </message>
    <message>
        <source>Side of the matched block, an odd number. A higher value gives less noise but coarser edges. bm needs at least 5, sgbm at most 15. Usual: 3 to 11 px.</source>
        <translation>Seitenlänge des verglichenen Blocks, ungerade. Ein höherer Wert gibt weniger Rauschen, aber gröbere Kanten. bm braucht mindestens 5, sgbm höchstens 15. Üblich: 3 bis 11 px.</translation>
    </message>
    <message>
        <source>Margin by which the best match must beat the second best. A higher value rejects more ambiguous matches. Usual: 5 to 15 %.</source>
        <translation>Vorsprung, den die beste Zuordnung vor der zweitbesten haben muss. Ein höherer Wert verwirft mehr mehrdeutige Zuordnungen. Üblich: 5 bis 15 %.</translation>
    </message>
    <message>
        <source>Left-right check</source>
        <translation>Links-rechts-Prüfung</translation>
    </message>
    <message>
        <source>Maximum difference between the matches from left to right and from right to left. A higher value rejects fewer occluded pixels. -1: off. Usual: 1 to 2 px.</source>
        <translation>Größter Unterschied zwischen den Zuordnungen von links nach rechts und zurück. Ein höherer Wert verwirft weniger verdeckte Bildpunkte. -1: aus. Üblich: 1 bis 2 px.</translation>
    </message>
    <message>
        <source>Minimum speckle size</source>
        <translation>Minimale Fleckengröße</translation>
    </message>
    <message>
        <source>Smaller connected components of the disparity are removed. A higher value removes more noise but also small objects. 0: off. Usual: 50 to 200 px.</source>
        <translation>Kleinere zusammenhängende Komponenten der Disparität werden entfernt. Ein höherer Wert entfernt mehr Rauschen, aber auch kleine Objekte. 0: aus. Üblich: 50 bis 200 px.</translation>
    </message>
    <message>
        <source>Maximum speckle step</source>
        <translation>Maximale Fleckenstufe</translation>
    </message>
    <message>
        <source>Maximum step of disparity inside a connected component. With a higher value more pixels are joined. Usual: 1 to 2 px.</source>
        <translation>Größter Disparitätssprung innerhalb einer zusammenhängenden Komponente. Bei einem höheren Wert werden mehr Bildpunkte verbunden. Üblich: 1 bis 2 px.</translation>
    </message>
    <message>
        <source>Limit of the image gradient before matching. With a higher value strong edges weigh more. Usual: 15 to 63.</source>
        <translation>Grenze des Bildgradienten vor der Zuordnung. Bei einem höheren Wert zählen starke Kanten mehr. Üblich: 15 bis 63.</translation>
    </message>
    <message>
        <source>Minimum texture</source>
        <translation>Minimale Textur</translation>
    </message>
    <message>
        <source>Areas with a lower mean gradient are not matched, such as over-exposed, dark or blank ones. A higher value leaves more areas without depth. 0: off. Usual: 0.1 to 0.5 grey/px.</source>
        <translation>Flächen mit kleinerem mittlerem Gradienten werden nicht zugeordnet, etwa überbelichtete, dunkle oder leere. Ein höherer Wert lässt mehr Flächen ohne Tiefe. 0: aus. Üblich: 0,1 bis 0,5 grey/px.</translation>
    </message>
    <message>
        <source>Frames averaged</source>
        <translation>Gemittelte Bilder</translation>
    </message>
    <message>
        <source>Frames over which disparity is averaged. For a static camera. A higher value gives less noise, but small changes appear 4 frames later. 1: off. Usual: 1 to 20 frames.</source>
        <translation>Bilder, über die die Disparität gemittelt wird. Für eine feste Kamera. Ein höherer Wert gibt weniger Rauschen, aber kleine Änderungen erscheinen 4 Bilder später. 1: aus. Üblich: 1 bis 20 Bilder.</translation>
    </message>
    <message>
        <source>Row correction (stereo_refine)</source>
        <translation>Zeilenkorrektur (stereo_refine)</translation>
    </message>
    <message>
        <source>Corrects a calibration whose rows of left and right differ. Rotates the right camera by up to one degree and adapts its focal length.</source>
        <translation>Korrigiert eine Kalibrierung, deren Zeilen links und rechts nicht übereinstimmen. Dreht die rechte Kamera um bis zu ein Grad und passt ihre Brennweite an.</translation>
    </message>
    <message>
        <source>Disparity smoothing</source>
        <translation>Disparitätsglättung</translation>
    </message>
    <message>
        <source>Width of the window over which similar disparities are averaged. A higher value smooths more and takes longer. 0: off. Usual: 5 to 31 px.</source>
        <translation>Breite des Fensters, über das ähnliche Disparitäten gemittelt werden. Ein höherer Wert glättet mehr und dauert länger. 0: aus. Üblich: 5 bis 31 px.</translation>
    </message>
    <message>
        <source>Maximum disparity slope</source>
        <translation>Maximale Disparitätssteigung</translation>
    </message>
    <message>
        <source>Pixels whose disparity changes by more than this per pixel are removed as flying pixels. A higher value removes fewer. 0: off. Usual: 0.4 to 1 px/px.</source>
        <translation>Bildpunkte, deren Disparität sich je Bildpunkt um mehr ändert, werden als fliegende Pixel entfernt. Ein höherer Wert entfernt weniger. 0: aus. Üblich: 0,4 bis 1 px/px.</translation>
    </message>
    <message>
        <source>Maximum frame age</source>
        <translation>Maximales Bildalter</translation>
    </message>
    <message>
        <source>How long the source may deliver no frame. After that no distance is shown. A higher value tolerates longer gaps. Usual: 0.3 to 1 s.</source>
        <translation>Wie lange die Quelle kein Bild liefern darf. Danach wird kein Abstand angezeigt. Ein höherer Wert duldet längere Lücken. Üblich: 0,3 bis 1 s.</translation>
    </message>
    <message>
        <source>Frozen after</source>
        <translation>Eingefroren nach</translation>
    </message>
    <message>
        <source>Identical frames in a row after which the source is reported as frozen. A higher value reports it later. Usual: 3 to 10 frames.</source>
        <translation>Gleiche Bilder nacheinander, nach denen die Quelle als eingefroren gemeldet wird. Ein höherer Wert meldet es später. Üblich: 3 bis 10 Bilder.</translation>
    </message>
    <message>
        <source>Minimum depth coverage</source>
        <translation>Minimale Tiefenabdeckung</translation>
    </message>
    <message>
        <source>Share of the pixels that must have a depth. Below it no distance is shown. A higher value is stricter. Usual: 0.05 to 0.3.</source>
        <translation>Anteil der Bildpunkte, die eine Tiefe haben müssen. Darunter wird kein Abstand angezeigt. Ein höherer Wert ist strenger. Üblich: 0,05 bis 0,3.</translation>
    </message>
    <message>
        <source>Camera motion limit</source>
        <translation>Grenze der Kamerabewegung</translation>
    </message>
    <message>
        <source>Share of the picture that may move. Above it the camera is assumed to move, and no distance is shown. A higher value is more tolerant. 1: off. Usual: 0.5 to 0.8.</source>
        <translation>Anteil des Bildes, der sich bewegen darf. Darüber gilt die Kamera als bewegt, und es wird kein Abstand angezeigt. Ein höherer Wert ist duldsamer. 1: aus. Üblich: 0,5 bis 0,8.</translation>
    </message>
    <message>
        <source>Maximum load age</source>
        <translation>Maximales Lastalter</translation>
    </message>
    <message>
        <source>How long a detected load may be out of sight. Until then its position is extrapolated; after that no distance is shown. Usual: 0.3 to 1 s.</source>
        <translation>Wie lange eine erkannte Last außer Sicht sein darf. Bis dahin wird ihre Position extrapoliert; danach wird kein Abstand angezeigt. Üblich: 0,3 bis 1 s.</translation>
    </message>
    <message>
        <source>Minimum observed share</source>
        <translation>Minimaler beobachteter Anteil</translation>
    </message>
    <message>
        <source>Share of the load&apos;s neighbourhood that must have been observed. Below it no distance is shown. A higher value is stricter. Usual: 0.1 to 0.5.</source>
        <translation>Anteil der Umgebung der Last, der beobachtet worden sein muss. Darunter wird kein Abstand angezeigt. Ein höherer Wert ist strenger. Üblich: 0,1 bis 0,5.</translation>
    </message>
</context>
<context>
    <name>StateText</name>
    <message>
        <source>no frame yet</source>
        <translation>noch kein Bild</translation>
    </message>
    <message>
        <source>this is frame %1</source>
        <translation>das ist Bild %1</translation>
    </message>
    <message>
        <source>this is frame %1 of %2</source>
        <translation>das ist Bild %1 von %2</translation>
    </message>
    <message>
        <source>Live: %1</source>
        <translation>Live: %1</translation>
    </message>
    <message>
        <source>Recording: %1</source>
        <translation>Aufnahme: %1</translation>
    </message>
    <message>
        <source>OPENING</source>
        <translation>ÖFFNET</translation>
    </message>
    <message>
        <source>LIVE</source>
        <translation>LIVE</translation>
    </message>
    <message>
        <source>RECORDING</source>
        <translation>AUFNAHME</translation>
    </message>
    <message>
        <source>PAUSED</source>
        <translation>ANGEHALTEN</translation>
    </message>
    <message>
        <source>END</source>
        <translation>ENDE</translation>
    </message>
    <message>
        <source>LOST</source>
        <translation>VERLOREN</translation>
    </message>
    <message>
        <source>Opening %1...</source>
        <translation>%1 wird geöffnet...</translation>
    </message>
    <message>
        <source>Rebuilding the model...</source>
        <translation>Das Modell wird neu aufgebaut...</translation>
    </message>
    <message>
        <source>Paused: %1. The picture is not live.</source>
        <translation>Angehalten: %1. Das Bild ist nicht live.</translation>
    </message>
    <message>
        <source>End of the recording: %1. The picture is not live.</source>
        <translation>Ende der Aufnahme: %1. Das Bild ist nicht live.</translation>
    </message>
    <message>
        <source>%1 is lost. Press Play to open it again.</source>
        <translation>%1 ist verloren. Zum erneuten Öffnen Abspielen drücken.</translation>
    </message>
    <message>
        <source>NO SOURCE</source>
        <translation>KEINE QUELLE</translation>
    </message>
    <message>
        <source>Opening %1... Until then %2 continues.</source>
        <translation>%1 wird geöffnet... Bis dahin läuft %2 weiter.</translation>
    </message>
    <message>
        <source>No source is open. Choose one in the Source menu, or drop a recording here.</source>
        <translation>Keine Quelle ist offen. Eine im Menü Quelle wählen oder eine Aufnahme hierher ziehen.</translation>
    </message>
    <message>
        <source>The model will be rebuilt with the next frame. </source>
        <translation>Das Modell wird mit dem nächsten Bild neu aufgebaut. </translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>Unreadable frame</source>
        <translation>Bild nicht lesbar</translation>
    </message>
    <message>
        <source>Frozen picture</source>
        <translation>Bild eingefroren</translation>
    </message>
    <message>
        <source>Too little depth</source>
        <translation>Zu wenig Tiefe</translation>
    </message>
    <message>
        <source>Camera moves</source>
        <translation>Kamera bewegt sich</translation>
    </message>
    <message>
        <source>No load</source>
        <translation>Keine Last</translation>
    </message>
    <message>
        <source>Load out of bounds</source>
        <translation>Last außerhalb</translation>
    </message>
    <message>
        <source>The source could not read this frame. Check the recording or the camera.</source>
        <translation>Die Quelle konnte dieses Bild nicht lesen. Aufnahme oder Kamera prüfen.</translation>
    </message>
    <message>
        <source>Too few pixels have a depth. Check light, lenses and calibration.</source>
        <translation>Zu wenige Bildpunkte haben eine Tiefe. Licht, Objektive und Kalibrierung prüfen.</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Caution</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Collision</source>
        <translation>Kollision</translation>
    </message>
    <message>
        <source>No distance</source>
        <translation>Kein Abstand</translation>
    </message>
    <message>
        <source>stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>crane</source>
        <translation>Kran</translation>
    </message>
    <message>
        <source>model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>clearance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>inside the load</source>
        <translation>in der Last</translation>
    </message>
    <message>
        <source>a face of the load</source>
        <translation>einer Fläche der Last</translation>
    </message>
    <message>
        <source>an edge of the load</source>
        <translation>einer Kante der Last</translation>
    </message>
    <message>
        <source>a corner of the load</source>
        <translation>einer Ecke der Last</translation>
    </message>
    <message>
        <source>occupied</source>
        <translation>belegt</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>checks</source>
        <translation>Prüfung</translation>
    </message>
    <message>
        <source>Tool lost</source>
        <translation>Werkzeug verloren</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Search too short</source>
        <translation>Suche zu kurz</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>boom %1</source>
        <translation>Ausleger %1</translation>
    </message>
    <message>
        <source>boom</source>
        <translation>Ausleger</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>No frames arrive</source>
        <translation>Keine Bilder</translation>
    </message>
    <message>
        <source>No tool selected</source>
        <translation>Kein Werkzeug gewählt</translation>
    </message>
    <message>
        <source>Load not detected</source>
        <translation>Last nicht erkannt</translation>
    </message>
    <message>
        <source>Tool not found</source>
        <translation>Werkzeug nicht gefunden</translation>
    </message>
    <message>
        <source>Building the model</source>
        <translation>Modell entsteht</translation>
    </message>
    <message>
        <source>Unobserved</source>
        <translation>Unbeobachtet</translation>
    </message>
    <message>
        <source>The source delivers no frames. Check the camera and its cable, or press Play.</source>
        <translation>Die Quelle liefert keine Bilder. Kamera und Kabel prüfen oder Abspielen drücken.</translation>
    </message>
    <message>
        <source>The source repeats the same picture. Check the camera, then open it again.</source>
        <translation>Die Quelle wiederholt dasselbe Bild. Die Kamera prüfen, dann neu öffnen.</translation>
    </message>
    <message>
        <source>The whole picture moves, so the camera moves. Keep it still and wait.</source>
        <translation>Das ganze Bild bewegt sich, also bewegt sich die Kamera. Kamera ruhig halten und warten.</translation>
    </message>
    <message>
        <source>Boom and load cannot be masked without the tool. Bring the tool into sight, or draw its box again.</source>
        <translation>Ohne Werkzeug lassen sich Ausleger und Last nicht maskieren. Das Werkzeug in Sicht bringen oder seinen Rahmen neu zeichnen.</translation>
    </message>
    <message>
        <source>The load is found from the tool. Draw a box around the tool in the camera view.</source>
        <translation>Die Last wird vom Werkzeug aus gefunden. Im Kamerabild einen Rahmen um das Werkzeug ziehen.</translation>
    </message>
    <message>
        <source>The position of the load is not set. Draw a box around the tool that holds it, or enter the load in the parameters.</source>
        <translation>Die Position der Last ist nicht angegeben. Einen Rahmen um das Werkzeug ziehen, das sie hält, oder die Last bei den Parametern eingeben.</translation>
    </message>
    <message>
        <source>No load was detected at the tool. Turn the load into view, or enter its sizes and lock them.</source>
        <translation>Am Werkzeug wurde keine Last erkannt. Die Last ins Bild drehen, oder ihre Größen eingeben und festlegen (locked).</translation>
    </message>
    <message>
        <source>The load is outside the bounds. Move it or widen the bounds.</source>
        <translation>Die Last liegt außerhalb der Grenzen. Die Last bewegen oder die Grenzen weiten.</translation>
    </message>
    <message>
        <source>Tool or boom is watched but was not found in the cloud. Track the tool, or watch only the load.</source>
        <translation>Werkzeug oder Ausleger wird überwacht, wurde aber in der Wolke nicht gefunden. Das Werkzeug verfolgen oder nur die Last überwachen.</translation>
    </message>
    <message>
        <source>The model has too few frames so far. Wait a moment. If this message stays, lower probtresh.</source>
        <translation>Das Modell hat bisher zu wenige Bilder. Kurz warten. Bleibt diese Meldung, probtresh senken.</translation>
    </message>
    <message>
        <source>No obstacle was found, but the search ends before the caution distance. Raise the ray length or the search range.</source>
        <translation>Es wurde kein Hindernis gefunden, aber die Suche endet vor dem Vorsichtsabstand. Strahllänge oder Suchreichweite erhöhen.</translation>
    </message>
    <message>
        <source>Too little of the space around the load was observed. Turn the camera towards it.</source>
        <translation>Um die Last wurde zu wenig Raum beobachtet. Die Kamera darauf richten.</translation>
    </message>
    <message>
        <source>The position of the tool is unknown.</source>
        <translation>Die Position des Werkzeugs ist unbekannt.</translation>
    </message>
    <message>
        <source>No point was measured at the tool.</source>
        <translation>Am Werkzeug wurde kein Punkt gemessen.</translation>
    </message>
    <message>
        <source>The tool point lies on the ground or a wall.</source>
        <translation>Der Werkzeugpunkt liegt auf dem Boden oder einer Wand.</translation>
    </message>
    <message>
        <source>The tool is empty: no load extends from it.</source>
        <translation>Das Werkzeug ist leer: Keine Last ragt heraus.</translation>
    </message>
    <message>
        <source>The load points at the camera, which cannot see its length.</source>
        <translation>Die Last zeigt auf die Kamera, die ihre Länge nicht sehen kann.</translation>
    </message>
    <message>
        <source>An end of the load is occluded or outside the picture.</source>
        <translation>Ein Ende der Last ist verdeckt oder außerhalb des Bildes.</translation>
    </message>
    <message>
        <source>Only one face of the load is visible.</source>
        <translation>Nur eine Seite der Last ist sichtbar.</translation>
    </message>
    <message>
        <source>Too few points were measured on the load.</source>
        <translation>Auf der Last wurden zu wenige Punkte gemessen.</translation>
    </message>
    <message>
        <source>The body at the tool does not have the shape of a load.</source>
        <translation>Der Körper am Werkzeug hat nicht die Form einer Last.</translation>
    </message>
    <message>
        <source>The body at the tool is too large for a load.</source>
        <translation>Der Körper am Werkzeug ist zu groß für eine Last.</translation>
    </message>
    <message>
        <source>The load is outside the bounds.</source>
        <translation>Die Last liegt außerhalb der Grenzen.</translation>
    </message>
    <message>
        <source>%1: no obstacle in range</source>
        <translation>%1: kein Hindernis in Reichweite</translation>
    </message>
    <message>
        <source>unobserved</source>
        <translation>unbeobachtet</translation>
    </message>
    <message>
        <source>observed, free</source>
        <translation>beobachtet, frei</translation>
    </message>
</context>
<context>
    <name>ToolOverlay</name>
    <message>
        <source>%1 x %2</source>
        <translation>%1 x %2</translation>
    </message>
    <message>
        <source>%1: too small</source>
        <translation>%1: zu klein</translation>
    </message>
</context>
<context>
    <name>ToolTexts</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>Tool lost for %1</source>
        <translation>Werkzeug seit %1 verloren</translation>
    </message>
    <message>
        <source>Tool %1</source>
        <translation>Werkzeug %1</translation>
    </message>
    <message>
        <source>, no depth</source>
        <translation>, keine Tiefe</translation>
    </message>
    <message>
        <source>Tool tracked, confidence %1.</source>
        <translation>Werkzeug verfolgt, Konfidenz %1.</translation>
    </message>
    <message>
        <source>Tool position rejected for %1</source>
        <translation>Werkzeugposition seit %1 verworfen</translation>
    </message>
    <message>
        <source>Tool without depth for %1</source>
        <translation>Werkzeug seit %1 ohne Tiefe</translation>
    </message>
    <message>
        <source>Tool lost, and the tracker has stopped. Restart it or draw a new box. Until then there is no distance.</source>
        <translation>Werkzeug verloren, und der Verfolger hat aufgehört. Neu starten oder einen neuen Rahmen ziehen. Bis dahin gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Tool not found yet: boom and load cannot be masked, so there is no distance.</source>
        <translation>Werkzeug noch nicht gefunden: Ausleger und Last lassen sich nicht maskieren, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Tool without depth: boom and load cannot be masked, so there is no distance.</source>
        <translation>Werkzeug ohne Tiefe: Ausleger und Last lassen sich nicht maskieren, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>%1: boom and load cannot be masked, so there is no distance.</source>
        <translation>%1: Ausleger und Last lassen sich nicht maskieren, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Tool re-detected, confidence %1.</source>
        <translation>Werkzeug wiedererkannt, Konfidenz %1.</translation>
    </message>
    <message>
        <source>Tool out of sight for %1</source>
        <translation>Werkzeug seit %1 außer Sicht</translation>
    </message>
    <message>
        <source>: its position is derived from the load. After %1 it is lost.</source>
        <translation>: Seine Position wird aus der Last abgeleitet. Nach %1 gilt es als verloren.</translation>
    </message>
    <message>
        <source>: its position is extrapolated. After %1 it is lost.</source>
        <translation>: Seine Position wird extrapoliert. Nach %1 gilt es als verloren.</translation>
    </message>
    <message>
        <source>manual: the clicked pixel stays</source>
        <translation>manual: der angeklickte Bildpunkt bleibt</translation>
    </message>
    <message>
        <source>tld: learns, re-detects, can be saved</source>
        <translation>tld: lernt, erkennt wieder, speicherbar</translation>
    </message>
    <message>
        <source>cmt: tracks rotation and size</source>
        <translation>cmt: verfolgt Drehung und Größe</translation>
    </message>
    <message>
        <source>klt: fast, no re-detection</source>
        <translation>klt: schnell, ohne Wiedererkennung</translation>
    </message>
    <message>
        <source>csrt: accurate, slow, no re-detection</source>
        <translation>csrt: genau, langsam, ohne Wiedererkennung</translation>
    </message>
    <message>
        <source>Tool re-detected %1</source>
        <translation>Werkzeug wiedererkannt %1</translation>
    </message>
    <message>
        <source>, rejected</source>
        <translation>, verworfen</translation>
    </message>
    <message>
        <source>The tool stays at the clicked pixel and is not tracked.</source>
        <translation>Das Werkzeug bleibt am angeklickten Bildpunkt und wird nicht verfolgt.</translation>
    </message>
    <message>
        <source>No tool selected: draw a box around it in the camera view.</source>
        <translation>Kein Werkzeug gewählt: im Kamerabild einen Rahmen darum ziehen.</translation>
    </message>
    <message>
        <source>This tracker does not learn.</source>
        <translation>Dieser Verfolger lernt nicht.</translation>
    </message>
    <message>
        <source>Learning is off: the tracker uses only the views learnt so far.</source>
        <translation>Lernen ist aus: Der Verfolger verwendet nur die bisher gelernten Ansichten.</translation>
    </message>
    <message>
        <source>Learning new views of the tool.</source>
        <translation>Lernt neue Ansichten des Werkzeugs.</translation>
    </message>
    <message>
        <source>Learning is suspended: the tracker is not sure enough of the tool. It resumes by itself.</source>
        <translation>Lernen ist ausgesetzt: Der Verfolger ist sich des Werkzeugs nicht sicher genug. Es geht von selbst weiter.</translation>
    </message>
    <message>
        <source>Model: %1 views of the tool, %2 of the background.</source>
        <translation>Modell: %1 Ansichten des Werkzeugs, %2 des Hintergrunds.</translation>
    </message>
</context>
<context>
    <name>boomwatch::CameraView</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>No picture has arrived.</source>
        <translation>Es ist kein Bild angekommen.</translation>
    </message>
    <message>
        <source>This source has no picture.</source>
        <translation>Diese Quelle hat kein Bild.</translation>
    </message>
    <message>
        <source>To track the tool, drag a box around it, or press B, the arrow keys and Enter.
To set a fixed tool point, click it, or press the arrow keys and Enter.
To remove the tool, right-click or press Escape.</source>
        <translation>Werkzeug verfolgen: einen Rahmen darum ziehen, oder B, Pfeiltasten und Eingabe.
Festen Werkzeugpunkt setzen: klicken, oder Pfeiltasten und Eingabe.
Werkzeug entfernen: Rechtsklick oder Escape.</translation>
    </message>
</context>
<context>
    <name>boomwatch::DistanceBar</name>
    <message>
        <source>m</source>
        <translation>m</translation>
    </message>
    <message>
        <source>to %1</source>
        <translation>zu %1</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>Distance: %1, %2</source>
        <translation>Abstand: %1, %2</translation>
    </message>
    <message>
        <source>contact in %1 s</source>
        <translation>Berührung in %1 s</translation>
    </message>
    <message>
        <source>evidence %1 %</source>
        <translation>Beleg %1 %</translation>
    </message>
    <message>
        <source>no obstacle within %1 m</source>
        <translation>kein Hindernis innerhalb von %1 m</translation>
    </message>
    <message>
        <source>to unobserved space</source>
        <translation>zu unbeobachtetem Raum</translation>
    </message>
    <message>
        <source>from the %1</source>
        <translation>vom %1</translation>
    </message>
    <message>
        <source>observed all around it</source>
        <translation>ringsum alles beobachtet</translation>
    </message>
    <message>
        <source>%1 % around it unobserved: an obstacle may be nearer</source>
        <translation>%1 % ringsum unbeobachtet: ein Hindernis kann näher sein</translation>
    </message>
</context>
<context>
    <name>boomwatch::DistancePlot</name>
    <message>
        <source>time (s), 0 is now</source>
        <translation>Zeit (s), 0 ist jetzt</translation>
    </message>
    <message>
        <source>distance (m)</source>
        <translation>Abstand (m)</translation>
    </message>
    <message>
        <source>caution</source>
        <translation>Vorsicht</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>reported</source>
        <translation>gemeldet</translation>
    </message>
    <message>
        <source>truth</source>
        <translation>wahr</translation>
    </message>
    <message>
        <source>%1 s ago</source>
        <translation>vor %1 s</translation>
    </message>
    <message>
        <source>reported: %1</source>
        <translation>gemeldet: %1</translation>
    </message>
    <message>
        <source>truth: %1</source>
        <translation>wahr: %1</translation>
    </message>
    <message>
        <source>no obstacle in range</source>
        <translation>kein Hindernis in Reichweite</translation>
    </message>
</context>
<context>
    <name>boomwatch::HelpDialog</name>
    <message>
        <source>Boomwatch: help</source>
        <translation>Boomwatch: Hilfe</translation>
    </message>
    <message>
        <source>&lt;h3&gt;What you see&lt;/h3&gt;&lt;p&gt;The bar on the left shows the distance from the load to the nearest obstacle in the environment model. It begins to fill at the caution distance and is full at a collision. A hatched bar means that there is no distance; the reason is beside it.&lt;/p&gt;&lt;p&gt;The point cloud shows what the camera measures now. The watched space is green, the load is violet, masked points of the crane are red, and a line joins the nearest pair of points. The probability map shows how certain each cell of the model is. The environment model shows the depth of each cell: nearer cells are brighter, unobserved cells are hatched.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Was zu sehen ist&lt;/h3&gt;&lt;p&gt;Der Balken links zeigt den Abstand von der Last zum nächsten Hindernis im Umgebungsmodell. Er beginnt sich beim Vorsichtsabstand zu füllen und ist bei einer Kollision voll. Ein schraffierter Balken heißt, dass es keinen Abstand gibt; der Grund steht daneben.&lt;/p&gt;&lt;p&gt;Die Punktwolke zeigt, was die Kamera jetzt misst. Der überwachte Raum ist grün, die Last violett, maskierte Punkte des Krans sind rot, und eine Linie verbindet das nächste Punktepaar. Die Wahrscheinlichkeitskarte zeigt, wie sicher jede Zelle des Modells ist. Das Umgebungsmodell zeigt die Tiefe jeder Zelle: Nähere Zellen sind heller, unbeobachtete schraffiert.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;What the program cannot know&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;Occluded objects.&lt;/b&gt; Each cell holds the surface nearest to the camera. Objects behind it are not in the model.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Unobserved space.&lt;/b&gt; Occluded, dark, over-exposed or textureless areas have no depth. The bar shows the observed share of the neighbourhood.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Objects that have just appeared.&lt;/b&gt; The camera must see an object in several frames in a row before it enters the model.&lt;/li&gt;&lt;li&gt;&lt;b&gt;The distance while the tool is lost.&lt;/b&gt; Boom and load cannot be masked without the tool, so there is no distance.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Masked points.&lt;/b&gt; Points masked with the crane and its load are red and are not part of the distance.&lt;/li&gt;&lt;li&gt;&lt;b&gt;A moving camera.&lt;/b&gt; The model needs a camera that stands still.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;A paused or ended recording does not show the present. The caption over the bar says so.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Was das Programm nicht wissen kann&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;Verdeckte Objekte.&lt;/b&gt; Jede Zelle enthält die Fläche, die der Kamera am nächsten ist. Objekte dahinter sind nicht im Modell.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Unbeobachteter Raum.&lt;/b&gt; Verdeckte, dunkle, überbelichtete oder strukturlose Flächen haben keine Tiefe. Der Balken zeigt den beobachteten Anteil der Umgebung.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Objekte, die eben erst aufgetaucht sind.&lt;/b&gt; Die Kamera muss ein Objekt in mehreren Bildern nacheinander sehen, bevor es ins Modell gelangt.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Den Abstand, während das Werkzeug verloren ist.&lt;/b&gt; Ohne Werkzeug lassen sich Ausleger und Last nicht maskieren, also gibt es keinen Abstand.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Maskierte Punkte.&lt;/b&gt; Punkte, die mit Kran und Last maskiert werden, sind rot und gehen nicht in den Abstand ein.&lt;/li&gt;&lt;li&gt;&lt;b&gt;Eine bewegte Kamera.&lt;/b&gt; Das Modell braucht eine Kamera, die stillsteht.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;Eine angehaltene oder beendete Aufnahme zeigt nicht die Gegenwart. Das Wort über dem Balken sagt es.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Which tracker&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;tld&lt;/b&gt; is the default. It re-detects the tool after an occlusion, learns new views of it, and can be saved.&lt;/li&gt;&lt;li&gt;&lt;b&gt;cmt&lt;/b&gt; suits a tool with much texture that rotates in the picture or is partly occluded. It does not suit a small, blurred or smooth tool.&lt;/li&gt;&lt;li&gt;&lt;b&gt;csrt&lt;/b&gt; suits a fast computer and a tool that stays in sight.&lt;/li&gt;&lt;li&gt;&lt;b&gt;klt&lt;/b&gt; suits short runs on a slow computer. It does not re-detect a lost tool.&lt;/li&gt;&lt;/ul&gt;</source>
        <translation>&lt;h3&gt;Welcher Verfolger&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;tld&lt;/b&gt; ist der Standard. Er erkennt das Werkzeug nach einer Verdeckung wieder, lernt neue Ansichten und lässt sich speichern.&lt;/li&gt;&lt;li&gt;&lt;b&gt;cmt&lt;/b&gt; eignet sich für ein Werkzeug mit viel Struktur, das sich im Bild dreht oder teilweise verdeckt ist. Er eignet sich nicht für ein kleines, unscharfes oder glattes Werkzeug.&lt;/li&gt;&lt;li&gt;&lt;b&gt;csrt&lt;/b&gt; eignet sich für einen schnellen Rechner und ein Werkzeug, das in Sicht bleibt.&lt;/li&gt;&lt;li&gt;&lt;b&gt;klt&lt;/b&gt; eignet sich für kurze Läufe auf einem langsamen Rechner. Er erkennt ein verlorenes Werkzeug nicht wieder.&lt;/li&gt;&lt;/ul&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Keys&lt;/h3&gt;&lt;table cellpadding=&apos;3&apos;&gt;&lt;tr&gt;&lt;td&gt;Space&lt;/td&gt;&lt;td&gt;play or pause&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;. and ,&lt;/td&gt;&lt;td&gt;next frame, previous frame&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;L&lt;/td&gt;&lt;td&gt;loop the recording&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ctrl+O&lt;/td&gt;&lt;td&gt;open a recording&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ctrl+S&lt;/td&gt;&lt;td&gt;save a picture of the window&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;R&lt;/td&gt;&lt;td&gt;reset the 3-D view&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;F&lt;/td&gt;&lt;td&gt;fit the maps&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Drag in the camera view&lt;/td&gt;&lt;td&gt;track the tool in this box; or press B, the arrow keys and Enter&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Click in the camera view&lt;/td&gt;&lt;td&gt;set a fixed tool point&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Right-click in the camera view&lt;/td&gt;&lt;td&gt;remove the tool&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;h3&gt;Tasten&lt;/h3&gt;&lt;table cellpadding=&apos;3&apos;&gt;&lt;tr&gt;&lt;td&gt;Leertaste&lt;/td&gt;&lt;td&gt;abspielen oder anhalten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;. und ,&lt;/td&gt;&lt;td&gt;nächstes Bild, vorheriges Bild&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;L&lt;/td&gt;&lt;td&gt;die Aufnahme wiederholen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Strg+O&lt;/td&gt;&lt;td&gt;eine Aufnahme öffnen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Strg+S&lt;/td&gt;&lt;td&gt;ein Bild des Fensters speichern&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;R&lt;/td&gt;&lt;td&gt;3-D-Ansicht zurücksetzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;F&lt;/td&gt;&lt;td&gt;Karten einpassen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ziehen im Kamerabild&lt;/td&gt;&lt;td&gt;das Werkzeug in diesem Rahmen verfolgen; oder B, Pfeiltasten und Eingabe&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Klick ins Kamerabild&lt;/td&gt;&lt;td&gt;einen festen Werkzeugpunkt setzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Rechtsklick ins Kamerabild&lt;/td&gt;&lt;td&gt;das Werkzeug entfernen&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
</context>
<context>
    <name>boomwatch::Legend</name>
    <message>
        <source>Colours from %1 to %2</source>
        <translation>Farben von %1 bis %2</translation>
    </message>
</context>
<context>
    <name>boomwatch::MainWindow</name>
    <message>
        <source>Opened. %1</source>
        <translation>Geöffnet. %1</translation>
    </message>
    <message>
        <source>Boomwatch</source>
        <translation>Boomwatch</translation>
    </message>
    <message>
        <source>Controls</source>
        <translation>Bedienung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>%1 - Boomwatch</source>
        <translation>%1 - Boomwatch</translation>
    </message>
    <message>
        <source>Not opened: %1</source>
        <translation>Nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>Save a picture of the window</source>
        <translation>Ein Bild des Fensters speichern</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation>Werkzeug: %1</translation>
    </message>
    <message>
        <source>Source lost: %1</source>
        <translation>Quelle verloren: %1</translation>
    </message>
    <message>
        <source>The calibration does not fit: the rows of left and right differ by %1 px. Calibrate again, or switch on Row correction if it is off.</source>
        <translation>Die Kalibrierung passt nicht: Die Zeilen von links und rechts weichen um %1 px voneinander ab. Neu kalibrieren, oder die Zeilenkorrektur einschalten, falls sie aus ist.</translation>
    </message>
    <message>
        <source>The calibration does not fit: the rows of left and right differ by %1 px. The program corrects this. Calibrate again soon.</source>
        <translation>Die Kalibrierung passt nicht: Die Zeilen von links und rechts weichen um %1 px voneinander ab. Das Programm korrigiert das. Bald neu kalibrieren.</translation>
    </message>
    <message>
        <source>Parameters not applied: %1</source>
        <translation>Parameter nicht übernommen: %1</translation>
    </message>
    <message>
        <source>Frame rejected: %1</source>
        <translation>Bild abgelehnt: %1</translation>
    </message>
    <message>
        <source>The tool will be set with the next frame.</source>
        <translation>Das Werkzeug wird mit dem nächsten Bild gesetzt.</translation>
    </message>
    <message>
        <source>%1 cannot be written. Choose another folder.</source>
        <translation>%1 kann nicht geschrieben werden. Einen anderen Ordner wählen.</translation>
    </message>
    <message>
        <source>%1 is not a known recording. Drop a folder with left and right pictures, with depth pictures, or with PCD or PLY files.</source>
        <translation>%1 ist keine bekannte Aufnahme. Einen Ordner mit linken und rechten Bildern, mit Tiefenbildern oder mit PCD- oder PLY-Dateien hierher ziehen.</translation>
    </message>
</context>
<context>
    <name>boomwatch::MapView</name>
    <message>
        <source>Probability map</source>
        <translation>Wahrscheinlichkeitskarte</translation>
    </message>
    <message>
        <source>Environment model</source>
        <translation>Umgebungsmodell</translation>
    </message>
    <message>
        <source>There is no model yet.</source>
        <translation>Es gibt noch kein Modell.</translation>
    </message>
    <message>
        <source>ignored, too small</source>
        <translation>ignoriert, zu klein</translation>
    </message>
</context>
<context>
    <name>boomwatch::ParameterDock</name>
    <message>
        <source>Presets (*.yaml *.yml)</source>
        <translation>Voreinstellungen (*.yaml *.yml)</translation>
    </message>
    <message>
        <source>Parameters</source>
        <translation>Parameter</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Search parameters</source>
        <translation>Parameter suchen</translation>
    </message>
    <message>
        <source>Load...</source>
        <translation>Laden...</translation>
    </message>
    <message>
        <source>Load a preset</source>
        <translation>Eine Voreinstellung laden</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Save these values as a preset</source>
        <translation>Diese Werte als Voreinstellung speichern</translation>
    </message>
    <message>
        <source>Reset all</source>
        <translation>Alle zurück</translation>
    </message>
    <message>
        <source>No object enters the model: cells only reach p_prior / (1 - p_post), or log_odds_high. Lower the threshold.</source>
        <translation>Kein Objekt gelangt ins Modell: Zellen erreichen nur p_prior / (1 - p_post) oder log_odds_high. Die Schwelle senken.</translation>
    </message>
    <message>
        <source>No object leaves the model: a cell stays occupied even when the camera sees through it. Raise the threshold.</source>
        <translation>Kein Objekt verlässt das Modell: Eine Zelle bleibt belegt, auch wenn die Kamera hindurchsieht. Die Schwelle erhöhen.</translation>
    </message>
    <message>
        <source>The search ends before the caution distance. If it finds no obstacle, there is no distance. Raise this value.</source>
        <translation>Die Suche endet vor dem Vorsichtsabstand. Findet sie kein Hindernis, gibt es keinen Abstand. Diesen Wert erhöhen.</translation>
    </message>
    <message>
        <source>Reset every parameter to its default</source>
        <translation>Jeden Parameter auf den Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Not applied until these agree: %1</source>
        <translation>Nicht übernommen, bis diese zusammenpassen: %1</translation>
    </message>
    <message>
        <source>Not applied</source>
        <translation>Nicht übernommen</translation>
    </message>
</context>
<context>
    <name>boomwatch::ParameterEditor</name>
    <message>
        <source>%1 to %2%3</source>
        <translation>%1 bis %2%3</translation>
    </message>
    <message>
        <source>off, or %1</source>
        <translation>aus, oder %1</translation>
    </message>
</context>
<context>
    <name>boomwatch::ParameterRow</name>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
    </message>
    <message>
        <source>Reset to the default</source>
        <translation>Auf den Standard zurücksetzen</translation>
    </message>
</context>
<context>
    <name>boomwatch::PlayerBar</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>%1x</source>
        <translation>%1x</translation>
    </message>
    <message>
        <source>fastest</source>
        <translation>schnellstens</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>Position in the recording</source>
        <translation>Stelle in der Aufnahme</translation>
    </message>
    <message>
        <source>Playing</source>
        <translation>Läuft</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Live</source>
        <translation>Live</translation>
    </message>
    <message>
        <source>Paused</source>
        <translation>Angehalten</translation>
    </message>
    <message>
        <source>End</source>
        <translation>Ende</translation>
    </message>
    <message>
        <source>Lost</source>
        <translation>Verloren</translation>
    </message>
    <message>
        <source>%1 / %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <source>Previous frame</source>
        <translation>Vorheriges Bild</translation>
    </message>
    <message>
        <source>Next frame</source>
        <translation>Nächstes Bild</translation>
    </message>
    <message>
        <source>Loop</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Playback speed of a recording. fastest: as fast as frames can be processed.</source>
        <translation>Abspieltempo einer Aufnahme. schnellstens: so schnell, wie Bilder verarbeitet werden können.</translation>
    </message>
</context>
<context>
    <name>boomwatch::PointCloudView</name>
    <message>
        <source>depth %1</source>
        <translation>Tiefe %1</translation>
    </message>
    <message>
        <source>height, y = %1</source>
        <translation>Höhe, y = %1</translation>
    </message>
    <message>
        <source>coloured as in the picture</source>
        <translation>gefärbt wie im Bild</translation>
    </message>
</context>
<context>
    <name>boomwatch::SourceDialog</name>
    <message>
        <source>A .bag, .mcap or .db3 file, or ROS 2&apos;s folder of them</source>
        <translation>Eine Datei .bag, .mcap oder .db3, oder der Ordner von ROS 2</translation>
    </message>
    <message>
        <source>Bag (ROS, Foxglove)</source>
        <translation>Bag (ROS, Foxglove)</translation>
    </message>
    <message>
        <source>Bags (*.bag *.mcap *.db3)</source>
        <translation>Bags (*.bag *.mcap *.db3)</translation>
    </message>
    <message>
        <source>A folder with left and right pictures or videos</source>
        <translation>Ein Ordner mit linken und rechten Bildern oder Videos</translation>
    </message>
    <message>
        <source>A PCD or PLY file, or a folder of them</source>
        <translation>Eine PCD- oder PLY-Datei, oder ein Ordner davon</translation>
    </message>
    <message>
        <source>A folder with colour and depth pictures</source>
        <translation>Ein Ordner mit Farb- und Tiefenbildern</translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation>Ordner...</translation>
    </message>
    <message>
        <source>File...</source>
        <translation>Datei...</translation>
    </message>
    <message>
        <source>Open a source</source>
        <translation>Eine Quelle öffnen</translation>
    </message>
    <message>
        <source>Stereo recording</source>
        <translation>Stereoaufnahme</translation>
    </message>
    <message>
        <source>Point clouds</source>
        <translation>Punktwolken</translation>
    </message>
    <message>
        <source>Depth recording</source>
        <translation>Tiefenaufnahme</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>&amp;Art</translation>
    </message>
    <message>
        <source>C&amp;alibration</source>
        <translation>&amp;Kalibrierung</translation>
    </message>
    <message>
        <source>Point clouds (*.pcd *.ply)</source>
        <translation>Punktwolken (*.pcd *.ply)</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Calibrations (*.yaml *.yml *.xml *.txt);;All files (*)</source>
        <translation>Kalibrierungen (*.yaml *.yml *.xml *.txt);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Maps (*.asc *.yaml *.yml)</source>
        <translation>Karten (*.asc *.yaml *.yml)</translation>
    </message>
    <message>
        <source>A height or depth map: an ASCII grid, or its YAML file</source>
        <translation>Eine Höhen- oder Tiefenkarte: ein ASCII-Gitter oder seine YAML-Datei</translation>
    </message>
    <message>
        <source>LEFT,RIGHT: device numbers or addresses, or one for both</source>
        <translation>LINKS,RECHTS: Gerätenummern oder Adressen, oder eine für beide</translation>
    </message>
    <message>
        <source>&amp;Location</source>
        <translation>&amp;Ort</translation>
    </message>
    <message>
        <source>found beside the recording</source>
        <translation>neben der Aufnahme gefunden</translation>
    </message>
</context>
<context>
    <name>boomwatch::StateLine</name>
    <message>
        <source>Dismiss</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>boomwatch::StatusStrip</name>
    <message>
        <source>✓ valid</source>
        <translation>✓ gültig</translation>
    </message>
    <message>
        <source>✕ no distance: %1</source>
        <translation>✕ kein Abstand: %1</translation>
    </message>
    <message>
        <source>%1 fps</source>
        <translation>%1 Bilder/s</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Load last detected %1 s ago.</source>
        <translation>Last zuletzt vor %1 s erkannt.</translation>
    </message>
    <message>
        <source>%1 % of the points are masked as boom, tool and load.</source>
        <translation>%1 % der Punkte sind als Ausleger, Werkzeug und Last maskiert.</translation>
    </message>
    <message>
        <source>latency %1 ms</source>
        <translation>Latenz %1 ms</translation>
    </message>
    <message>
        <source>skipped %1, dropped %2</source>
        <translation>übersprungen %1, verworfen %2</translation>
    </message>
    <message>
        <source>Skipped frames were processed but replaced before the window showed them. Dropped frames came from a live source and were not read.</source>
        <translation>Übersprungene Bilder wurden verarbeitet, aber ersetzt, bevor das Fenster sie zeigte. Verworfene Bilder kamen von einer Live-Quelle und wurden nicht gelesen.</translation>
    </message>
    <message>
        <source>Time of this stage for the last frame, in milliseconds</source>
        <translation>Dauer dieser Stufe beim letzten Bild, in Millisekunden</translation>
    </message>
</context>
<context>
    <name>boomwatch::TrackingDock</name>
    <message>
        <source>Tracking</source>
        <translation>Verfolgung</translation>
    </message>
    <message>
        <source>Tracker</source>
        <translation>Verfolger</translation>
    </message>
    <message>
        <source>Other trackers</source>
        <translation>Andere Verfolger</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>Rahmen zeichnen</translation>
    </message>
    <message>
        <source>Load...</source>
        <translation>Laden...</translation>
    </message>
    <message>
        <source>Merge...</source>
        <translation>Vereinen...</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Learnt views</source>
        <translation>Gelernte Ansichten</translation>
    </message>
    <message>
        <source>Tool models (*.tool);;All files (*)</source>
        <translation>Werkzeugmodelle (*.tool);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Method that tracks the tool. A new tracker starts where the old one saw the tool.</source>
        <translation>Verfahren, das das Werkzeug verfolgt. Ein neuer Verfolger beginnt dort, wo der alte das Werkzeug sah.</translation>
    </message>
    <message>
        <source>tld: learn new views of the tool while tracking.</source>
        <translation>tld: beim Verfolgen neue Ansichten des Werkzeugs lernen.</translation>
    </message>
    <message>
        <source>Start a box in the camera view: the arrow keys size it, Enter starts tracking, Escape cancels. Or drag a box with the mouse.</source>
        <translation>Einen Rahmen im Kamerabild beginnen: Pfeiltasten ändern seine Größe, Eingabe startet die Verfolgung, Escape bricht ab. Oder einen Rahmen mit der Maus ziehen.</translation>
    </message>
    <message>
        <source>Restart</source>
        <translation>Neu starten</translation>
    </message>
    <message>
        <source>Restart the tracker where it last saw the tool, without the views learnt meanwhile.</source>
        <translation>Den Verfolger neu starten, wo er das Werkzeug zuletzt sah, ohne die inzwischen gelernten Ansichten.</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the tool and stop tracking.</source>
        <translation>Das Werkzeug entfernen und die Verfolgung beenden.</translation>
    </message>
    <message>
        <source>Find the tool with a saved model. Several files are merged. Only for tld.</source>
        <translation>Das Werkzeug mit einem gespeicherten Modell finden. Mehrere Dateien werden vereint. Nur für tld.</translation>
    </message>
    <message>
        <source>Merge saved models into the current one.</source>
        <translation>Gespeicherte Modelle mit dem aktuellen vereinen.</translation>
    </message>
    <message>
        <source>Save the current model.</source>
        <translation>Das aktuelle Modell speichern.</translation>
    </message>
    <message>
        <source>The latest learnt views: above of the tool, below of the background.</source>
        <translation>Die zuletzt gelernten Ansichten: oben vom Werkzeug, unten vom Hintergrund.</translation>
    </message>
    <message>
        <source>Merge tool models</source>
        <translation>Werkzeugmodelle vereinen</translation>
    </message>
    <message>
        <source>Load a tool model</source>
        <translation>Ein Werkzeugmodell laden</translation>
    </message>
    <message>
        <source>Save the tool model</source>
        <translation>Das Werkzeugmodell speichern</translation>
    </message>
</context>
<context>
    <name>boomwatch::VtkCanvas</name>
    <message>
        <source>There is no 3-D view: the display platform &quot;%1&quot; has no OpenGL. Start the program on a desktop to see it.</source>
        <translation>Es gibt keine 3-D-Ansicht: Die Anzeigeplattform &quot;%1&quot; hat kein OpenGL. Das Programm auf einem Desktop starten, um sie zu sehen.</translation>
    </message>
    <message>
        <source>There is no 3-D view: OpenGL 3.2 could not be started. Install or update the graphics driver, or set LIBGL_ALWAYS_SOFTWARE=1 before you start the program.</source>
        <translation>Es gibt keine 3-D-Ansicht: OpenGL 3.2 ließ sich nicht starten. Den Grafiktreiber installieren oder erneuern, oder vor dem Start LIBGL_ALWAYS_SOFTWARE=1 setzen.</translation>
    </message>
    <message>
        <source>Point cloud</source>
        <translation>Punktwolke</translation>
    </message>
</context>
</TS>
