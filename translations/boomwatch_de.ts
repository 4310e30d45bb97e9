<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Menus</name>
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
        <source>x from</source>
        <translation>x von</translation>
    </message>
    <message>
        <source>Left limit of the watched space</source>
        <translation>Linke Grenze des überwachten Raums</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x bis</translation>
    </message>
    <message>
        <source>Right limit of the watched space</source>
        <translation>Rechte Grenze des überwachten Raums</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y von</translation>
    </message>
    <message>
        <source>Upper limit of the watched space (y points down)</source>
        <translation>Obere Grenze des überwachten Raums (y zeigt nach unten)</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y bis</translation>
    </message>
    <message>
        <source>Lower limit of the watched space (y points down)</source>
        <translation>Untere Grenze des überwachten Raums (y zeigt nach unten)</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z von</translation>
    </message>
    <message>
        <source>Nearest distance that is watched</source>
        <translation>Kleinste Entfernung, die überwacht wird</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z bis</translation>
    </message>
    <message>
        <source>Farthest distance that is watched</source>
        <translation>Größte Entfernung, die überwacht wird</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>Modell</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>Side of a cell of the environment model (R)</source>
        <translation>Seitenlänge einer Zelle des Umgebungsmodells (R)</translation>
    </message>
    <message>
        <source>Cell depth</source>
        <translation>Zellentiefe</translation>
    </message>
    <message>
        <source>nearest: that of the nearest point in a cell (Eq. 10), up to half a cell too near where a surface is seen at an angle; surface: the mean of the surface there</source>
        <translation>nearest: die des nächsten Punktes einer Zelle (Gl. 10), bis zu einer halben Zelle zu nah, wo eine Fläche schräg gesehen wird; surface: das Mittel der Fläche dort</translation>
    </message>
    <message>
        <source>probtresh</source>
        <translation>probtresh</translation>
    </message>
    <message>
        <source>A cell must be more probable than this to count (P_limit)</source>
        <translation>Wahrscheinlichkeit, die eine Zelle überschreiten muss, um zu zählen (P_limit)</translation>
    </message>
    <message>
        <source>p prior</source>
        <translation>p prior</translation>
    </message>
    <message>
        <source>Probability that a hit adds (Eq. 8)</source>
        <translation>Wahrscheinlichkeit, die ein Treffer hinzufügt (Gl. 8)</translation>
    </message>
    <message>
        <source>p post</source>
        <translation>p post</translation>
    </message>
    <message>
        <source>Share of the probability left after each frame (Eq. 8)</source>
        <translation>Anteil der Wahrscheinlichkeit, der nach jedem Bild bleibt (Gl. 8)</translation>
    </message>
    <message>
        <source>Memory limit</source>
        <translation>Speichergrenze</translation>
    </message>
    <message>
        <source>Memory that the model may take</source>
        <translation>Speicher, den das Modell belegen darf</translation>
    </message>
    <message>
        <source>Clearance</source>
        <translation>Freiraum</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Verfahren</translation>
    </message>
    <message>
        <source>exact: every cell; rays: the thesis&apos;s search rays, which miss what lies between them</source>
        <translation>exact: jede Zelle; rays: die Suchstrahlen der Masterarbeit, die übersehen, was zwischen ihnen liegt</translation>
    </message>
    <message>
        <source>Interval</source>
        <translation>Abstand der Strahlen</translation>
    </message>
    <message>
        <source>rays: cells between two search rays (I)</source>
        <translation>rays: Zellen zwischen zwei Suchstrahlen (I)</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>Strahllänge</translation>
    </message>
    <message>
        <source>rays: length of a search ray (L)</source>
        <translation>rays: Länge eines Suchstrahls (L)</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>Reichweite</translation>
    </message>
    <message>
        <source>exact: beyond this there is nothing in range</source>
        <translation>exact: jenseits davon gilt nichts mehr als in Reichweite</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Caution below</source>
        <translation>Vorsicht unter</translation>
    </message>
    <message>
        <source>The bar begins here</source>
        <translation>Hier beginnt der Balken</translation>
    </message>
    <message>
        <source>Warning below</source>
        <translation>Warnung unter</translation>
    </message>
    <message>
        <source>The warning begins here</source>
        <translation>Hier beginnt die Warnung</translation>
    </message>
    <message>
        <source>Load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Load given by</source>
        <translation>Last gegeben durch</translation>
    </message>
    <message>
        <source>Centre x</source>
        <translation>Mitte x</translation>
    </message>
    <message>
        <source>Centre of the load, to the right of the camera</source>
        <translation>Mitte der Last, rechts von der Kamera</translation>
    </message>
    <message>
        <source>Centre y</source>
        <translation>Mitte y</translation>
    </message>
    <message>
        <source>Centre of the load, below the camera</source>
        <translation>Mitte der Last, unterhalb der Kamera</translation>
    </message>
    <message>
        <source>Centre z</source>
        <translation>Mitte z</translation>
    </message>
    <message>
        <source>Centre of the load, in front of the camera</source>
        <translation>Mitte der Last, vor der Kamera</translation>
    </message>
    <message>
        <source>Size x</source>
        <translation>Größe x</translation>
    </message>
    <message>
        <source>Full size along the load&apos;s own x</source>
        <translation>Volle Größe entlang der eigenen x-Achse der Last</translation>
    </message>
    <message>
        <source>Size y</source>
        <translation>Größe y</translation>
    </message>
    <message>
        <source>Full size along the load&apos;s own y</source>
        <translation>Volle Größe entlang der eigenen y-Achse der Last</translation>
    </message>
    <message>
        <source>Size z</source>
        <translation>Größe z</translation>
    </message>
    <message>
        <source>Full size along the load&apos;s own z</source>
        <translation>Volle Größe entlang der eigenen z-Achse der Last</translation>
    </message>
    <message>
        <source>Yaw</source>
        <translation>Gieren</translation>
    </message>
    <message>
        <source>Turn about y, first</source>
        <translation>Drehung um y, zuerst</translation>
    </message>
    <message>
        <source>Pitch</source>
        <translation>Nicken</translation>
    </message>
    <message>
        <source>Turn about x, second</source>
        <translation>Drehung um x, als zweite</translation>
    </message>
    <message>
        <source>Roll</source>
        <translation>Rollen</translation>
    </message>
    <message>
        <source>Turn about z, third</source>
        <translation>Drehung um z, als dritte</translation>
    </message>
    <message>
        <source>Filter</source>
        <translation>Filter</translation>
    </message>
    <message>
        <source>z reprojection</source>
        <translation>z-Umprojektion</translation>
    </message>
    <message>
        <source>Move every kept point to this z</source>
        <translation>Jeden behaltenen Punkt auf dieses z verschieben</translation>
    </message>
    <message>
        <source>Low pass</source>
        <translation>Tiefpass</translation>
    </message>
    <message>
        <source>Remove outliers; slow</source>
        <translation>Ausreißer entfernen; langsam</translation>
    </message>
    <message>
        <source>Low pass method</source>
        <translation>Tiefpassverfahren</translation>
    </message>
    <message>
        <source>statistical: by mean distance to the neighbours; radius: by number of neighbours</source>
        <translation>statistical: nach mittlerem Abstand zu den Nachbarn; radius: nach Zahl der Nachbarn</translation>
    </message>
    <message>
        <source>Neighbours</source>
        <translation>Nachbarn</translation>
    </message>
    <message>
        <source>statistical: neighbours looked at</source>
        <translation>statistical: betrachtete Nachbarn</translation>
    </message>
    <message>
        <source>Deviations</source>
        <translation>Abweichungen</translation>
    </message>
    <message>
        <source>statistical: standard deviations allowed</source>
        <translation>statistical: erlaubte Standardabweichungen</translation>
    </message>
    <message>
        <source>Neighbour radius</source>
        <translation>Nachbarradius</translation>
    </message>
    <message>
        <source>radius: how far a neighbour may be</source>
        <translation>radius: wie weit ein Nachbar entfernt sein darf</translation>
    </message>
    <message>
        <source>Neighbours needed</source>
        <translation>Nötige Nachbarn</translation>
    </message>
    <message>
        <source>radius: neighbours a point must have</source>
        <translation>radius: Nachbarn, die ein Punkt haben muss</translation>
    </message>
    <message>
        <source>Cluster tolerance</source>
        <translation>Gruppenabstand</translation>
    </message>
    <message>
        <source>Points nearer than this belong together</source>
        <translation>Punkte, die näher beieinander liegen, gehören zusammen</translation>
    </message>
    <message>
        <source>Cluster minimum</source>
        <translation>Kleinste Gruppe</translation>
    </message>
    <message>
        <source>Smaller clusters are noise and go</source>
        <translation>Kleinere Gruppen sind Rauschen und entfallen</translation>
    </message>
    <message>
        <source>Stereo</source>
        <translation>Stereo</translation>
    </message>
    <message>
        <source>Matcher</source>
        <translation>Zuordnung</translation>
    </message>
    <message>
        <source>sgbm: semi-global, 3-way; bm: block matching, faster and sparser</source>
        <translation>sgbm: semi-global, 3 Richtungen; bm: Blockvergleich, schneller und lückenhafter</translation>
    </message>
    <message>
        <source>Smallest disparity</source>
        <translation>Kleinste Disparität</translation>
    </message>
    <message>
        <source>Disparity at which the search begins</source>
        <translation>Disparität, bei der die Suche beginnt</translation>
    </message>
    <message>
        <source>Disparities</source>
        <translation>Disparitäten</translation>
    </message>
    <message>
        <source>Disparities searched, a multiple of 16; more sees nearer</source>
        <translation>Durchsuchte Disparitäten, ein Vielfaches von 16; mehr sieht näher</translation>
    </message>
    <message>
        <source>Block size</source>
        <translation>Blockgröße</translation>
    </message>
    <message>
        <source>Side of the matched block, odd; bm needs at least 5</source>
        <translation>Seite des verglichenen Blocks, ungerade; bm braucht mindestens 5</translation>
    </message>
    <message>
        <source>Uniqueness</source>
        <translation>Eindeutigkeit</translation>
    </message>
    <message>
        <source>By how much the best match must beat the second</source>
        <translation>Um wie viel die beste Zuordnung die zweite übertreffen muss</translation>
    </message>
    <message>
        <source>Consistency</source>
        <translation>Übereinstimmung</translation>
    </message>
    <message>
        <source>Difference allowed between left and right; -1 is off</source>
        <translation>Erlaubter Unterschied zwischen links und rechts; -1 ist aus</translation>
    </message>
    <message>
        <source>Speckle window</source>
        <translation>Fleckengröße</translation>
    </message>
    <message>
        <source>Smaller connected pieces are removed; 0 is off</source>
        <translation>Kleinere zusammenhängende Stücke werden entfernt; 0 ist aus</translation>
    </message>
    <message>
        <source>Speckle range</source>
        <translation>Fleckenstufe</translation>
    </message>
    <message>
        <source>Disparity step inside a piece</source>
        <translation>Disparitätssprung innerhalb eines Stücks</translation>
    </message>
    <message>
        <source>Prefilter cap</source>
        <translation>Vorfiltergrenze</translation>
    </message>
    <message>
        <source>Truncation of the gradient before matching</source>
        <translation>Begrenzung des Gradienten vor der Zuordnung</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>Textur</translation>
    </message>
    <message>
        <source>Areas with less mean gradient are not matched: over-exposed, unlit or blank ones give no depth; 0 is off</source>
        <translation>Flächen mit kleinerem mittleren Gradienten werden nicht zugeordnet: überbelichtete, dunkle oder leere geben keine Tiefe; 0 ist aus</translation>
    </message>
    <message>
        <source>Validity</source>
        <translation>Gültigkeit</translation>
    </message>
    <message>
        <source>Frame age</source>
        <translation>Bildalter</translation>
    </message>
    <message>
        <source>Longer without a frame, and there is no distance</source>
        <translation>Länger ohne Bild, und es gibt keinen Abstand</translation>
    </message>
    <message>
        <source>Identical frames</source>
        <translation>Gleiche Bilder</translation>
    </message>
    <message>
        <source>This many equal frames in a row mean a frozen source</source>
        <translation>So viele gleiche Bilder nacheinander bedeuten eine eingefrorene Quelle</translation>
    </message>
    <message>
        <source>Smallest fill</source>
        <translation>Kleinste Füllung</translation>
    </message>
    <message>
        <source>Share of pixels that must have a depth</source>
        <translation>Anteil der Bildpunkte, die eine Tiefe haben müssen</translation>
    </message>
    <message>
        <source>Scene motion</source>
        <translation>Bildbewegung</translation>
    </message>
    <message>
        <source>If a larger share of the picture moves, the camera moves; 1 is off</source>
        <translation>Bewegt sich ein größerer Anteil des Bildes, bewegt sich die Kamera; 1 ist aus</translation>
    </message>
    <message>
        <source>Smallest observed share</source>
        <translation>Kleinster gesehener Anteil</translation>
    </message>
    <message>
        <source>Share of the load&apos;s neighbourhood that must have been observed</source>
        <translation>Anteil der Umgebung der Last, der gesehen worden sein muss</translation>
    </message>
    <message>
        <source>Average</source>
        <translation>Mittelung</translation>
    </message>
    <message>
        <source>Frames that a disparity is the mean of: less noise from a still camera, but small changes are seen 4 frames later; 1 is off</source>
        <translation>Bilder, über die eine Disparität gemittelt wird: weniger Rauschen bei stehender Kamera, aber kleine Änderungen werden 4 Bilder später gesehen; 1 ist aus</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Width of the neighbourhood that a disparity is the mean of; 0 is off</source>
        <translation>Breite der Nachbarschaft, über die eine Disparität gemittelt wird; 0 ist aus</translation>
    </message>
    <message>
        <source>Caution time</source>
        <translation>Vorsichtszeit</translation>
    </message>
    <message>
        <source>Caution also begins when the load, as it moves, would touch something within this time; 0 is off</source>
        <translation>Vorsicht beginnt auch, wenn die Last bei ihrer jetzigen Bewegung in dieser Zeit etwas berühren würde; 0 ist aus</translation>
    </message>
    <message>
        <source>Warning time</source>
        <translation>Warnzeit</translation>
    </message>
    <message>
        <source>The warning also begins when the load, as it moves, would touch something within this time; 0 is off</source>
        <translation>Die Warnung beginnt auch, wenn die Last bei ihrer jetzigen Bewegung in dieser Zeit etwas berühren würde; 0 ist aus</translation>
    </message>
    <message>
        <source>Deadband</source>
        <translation>Totband</translation>
    </message>
    <message>
        <source>A level ends this much farther away than it begins</source>
        <translation>Eine Stufe endet um so viel weiter entfernt, als sie beginnt</translation>
    </message>
    <message>
        <source>Release delay</source>
        <translation>Rückfallverzögerung</translation>
    </message>
    <message>
        <source>A level ends only after a lower one would have done for so long; a load that retreats is not kept waiting</source>
        <translation>Eine Stufe endet erst, wenn so lange eine niedrigere genügt hätte; eine Last, die sich entfernt, muss nicht warten</translation>
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
        <source>tld: learns, finds again, can be saved; cmt: turns and grows with the tool; klt and csrt: follow only; manual: the click stays where it is</source>
        <translation>tld: lernt, findet wieder, kann gespeichert werden; cmt: dreht sich und wächst mit dem Werkzeug; klt und csrt: folgen nur; manual: der Klick bleibt, wo er ist</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>tld: go on learning what the tool looks like; off: only what is known</source>
        <translation>tld: weiter lernen, wie das Werkzeug aussieht; aus: nur, was bekannt ist</translation>
    </message>
    <message>
        <source>Tool point</source>
        <translation>Werkzeugpunkt</translation>
    </message>
    <message>
        <source>right: the box&apos;s centre or the next measured pixel on its right; near: what is near in the middle of the box, for a grapple that can be seen through</source>
        <translation>right: die Mitte des Rahmens oder der nächste gemessene Bildpunkt rechts davon; near: was in der Mitte des Rahmens nah ist, für einen Greifer, durch den man hindurchsieht</translation>
    </message>
    <message>
        <source>Tool age</source>
        <translation>Werkzeugalter</translation>
    </message>
    <message>
        <source>Longer without the tool, and there is no distance; until then it is taken to go on as it moved</source>
        <translation>Länger ohne Werkzeug, und es gibt keinen Abstand; bis dahin gilt, dass es sich weiterbewegt wie zuvor</translation>
    </message>
    <message>
        <source>Tool noise</source>
        <translation>Werkzeugrauschen</translation>
    </message>
    <message>
        <source>Standard deviation of the tool&apos;s point as measured; more is smoother</source>
        <translation>Standardabweichung des gemessenen Werkzeugpunkts; mehr ist glatter</translation>
    </message>
    <message>
        <source>Tool acceleration</source>
        <translation>Werkzeugbeschleunigung</translation>
    </message>
    <message>
        <source>How quickly the tool changes its velocity; less is smoother</source>
        <translation>Wie schnell das Werkzeug seine Geschwindigkeit ändert; weniger ist glatter</translation>
    </message>
    <message>
        <source>Tool speed</source>
        <translation>Werkzeuggeschwindigkeit</translation>
    </message>
    <message>
        <source>The fastest the tool can move; a tracker that leaps further follows something else, and must look for the tool again</source>
        <translation>Schneller kann sich das Werkzeug nicht bewegen; eine Verfolgung, die weiter springt, folgt etwas anderem und muss das Werkzeug neu suchen</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisierung</translation>
    </message>
    <message>
        <source>thesis: Eq. 8-9, one miss can drop a cell; hysteresis: a cell leaves only at the leave threshold; log_odds: Bayes&apos; rule</source>
        <translation>thesis: Gl. 8-9, ein Fehlen kann eine Zelle löschen; hysteresis: eine Zelle geht erst an der Austrittsschwelle; log_odds: Satz von Bayes</translation>
    </message>
    <message>
        <source>Leave threshold</source>
        <translation>Austrittsschwelle</translation>
    </message>
    <message>
        <source>hysteresis: at this probability a cell no longer counts; below probtresh</source>
        <translation>hysteresis: bei dieser Wahrscheinlichkeit zählt eine Zelle nicht mehr; unter probtresh</translation>
    </message>
    <message>
        <source>Odds hit</source>
        <translation>Odds Treffer</translation>
    </message>
    <message>
        <source>log_odds: probability of a cell that is measured once</source>
        <translation>log_odds: Wahrscheinlichkeit einer Zelle, die einmal gemessen wurde</translation>
    </message>
    <message>
        <source>Odds miss</source>
        <translation>Odds Fehlen</translation>
    </message>
    <message>
        <source>log_odds: probability of a cell that is missed once</source>
        <translation>log_odds: Wahrscheinlichkeit einer Zelle, die einmal fehlte</translation>
    </message>
    <message>
        <source>Odds low</source>
        <translation>Odds unten</translation>
    </message>
    <message>
        <source>log_odds: a hit starts from this probability at least</source>
        <translation>log_odds: ein Treffer beginnt mindestens bei dieser Wahrscheinlichkeit</translation>
    </message>
    <message>
        <source>Odds high</source>
        <translation>Odds oben</translation>
    </message>
    <message>
        <source>log_odds: hits raise the probability to this at most</source>
        <translation>log_odds: Treffer heben die Wahrscheinlichkeit höchstens bis hierher</translation>
    </message>
    <message>
        <source>Refine</source>
        <translation>Verfeinern</translation>
    </message>
    <message>
        <source>Turn the right camera by up to a degree, and correct its focal length, so that the rows of both pictures agree</source>
        <translation>Die rechte Kamera um bis zu ein Grad drehen und ihre Brennweite berichtigen, damit die Zeilen beider Bilder übereinstimmen</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>Form</translation>
    </message>
    <message>
        <source>detected: a log, a box, or a box where there is no log</source>
        <translation>detected: ein Stamm, ein Kasten, oder ein Kasten, wo kein Stamm ist</translation>
    </message>
    <message>
        <source>Sizes</source>
        <translation>Maße</translation>
    </message>
    <message>
        <source>detected: learnt at first, then held until seen better, or locked to the sizes above (x is a log&apos;s length)</source>
        <translation>detected: anfangs gelernt, dann gehalten, bis sie besser zu sehen sind, oder fest die Maße darüber (x ist die Länge eines Stamms)</translation>
    </message>
    <message>
        <source>Learning time</source>
        <translation>Lernzeit</translation>
    </message>
    <message>
        <source>detected: over which the sizes are learnt</source>
        <translation>detected: so lange werden die Maße gelernt</translation>
    </message>
    <message>
        <source>Largest size</source>
        <translation>Größtes Maß</translation>
    </message>
    <message>
        <source>detected: what is longer is no load</source>
        <translation>detected: was länger ist, ist keine Last</translation>
    </message>
    <message>
        <source>Tool size</source>
        <translation>Werkzeuggröße</translation>
    </message>
    <message>
        <source>detected: what is nearer than half of this to the tool point is the tool, not the load</source>
        <translation>detected: was dem Werkzeugpunkt näher ist als die Hälfte davon, ist das Werkzeug, nicht die Last</translation>
    </message>
    <message>
        <source>Margin</source>
        <translation>Rand</translation>
    </message>
    <message>
        <source>detected: points so near to the load are taken out with it; else one cell</source>
        <translation>detected: Punkte, die der Last so nah sind, werden mit ihr herausgenommen; sonst eine Zelle</translation>
    </message>
    <message>
        <source>Load age</source>
        <translation>Alter der Last</translation>
    </message>
    <message>
        <source>Longer without seeing the load that is detected, and there is no distance</source>
        <translation>Wird die erkannte Last länger nicht gesehen, gibt es keinen Abstand</translation>
    </message>
    <message>
        <source>Projection</source>
        <translation>Projektion</translation>
    </message>
    <message>
        <source>parallel: columns along z (the thesis&apos;s); perspective: image rays, no gap behind near things; there a cell is resolution wide at half of z_max</source>
        <translation>parallel: Säulen entlang z (wie in der Arbeit); perspective: Bildstrahlen, keine Lücke hinter nahen Dingen; eine Zelle ist dann bei halbem z_max so breit wie die Auflösung</translation>
    </message>
    <message>
        <source>Unknown space</source>
        <translation>Unbekannter Raum</translation>
    </message>
    <message>
        <source>ignore: as if it were free (the thesis&apos;s); show: said and drawn, and too little seen is no distance; solid: what was never seen counts as an obstacle</source>
        <translation>ignore: als wäre er frei (wie in der Arbeit); show: wird gesagt und gezeichnet, und zu wenig Gesehenes ist kein Abstand; solid: was nie gesehen wurde, zählt als Hindernis</translation>
    </message>
    <message>
        <source>Smallest thing</source>
        <translation>Kleinstes Ding</translation>
    </message>
    <message>
        <source>What is smaller from corner to corner is drawn but does not count; 0 counts all</source>
        <translation>Was von Ecke zu Ecke kleiner ist, wird gezeichnet, zählt aber nicht; 0 zählt alles</translation>
    </message>
    <message>
        <source>Watched</source>
        <translation>Überwacht</translation>
    </message>
    <message>
        <source>Watch the distance from the load</source>
        <translation>Den Abstand von der Last überwachen</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>Werkzeug</translation>
    </message>
    <message>
        <source>Watch the distance from the tool that is followed</source>
        <translation>Den Abstand vom verfolgten Werkzeug überwachen</translation>
    </message>
    <message>
        <source>Boom</source>
        <translation>Ausleger</translation>
    </message>
    <message>
        <source>Watch the distance from the boom&apos;s segments, as far as they are seen</source>
        <translation>Den Abstand von den Teilen des Auslegers überwachen, soweit sie zu sehen sind</translation>
    </message>
    <message>
        <source>auto: detected where a tool is followed or the source has one, else what the source knows; scene: only what the source itself knows; manual: the values below; detected: found in every frame, at the tool</source>
        <translation>auto: erkannt, wo ein Werkzeug verfolgt wird oder die Quelle eines hat, sonst was die Quelle weiß; scene: nur, was die Quelle selbst weiß; manual: die Werte unten; detected: in jedem Bild am Werkzeug gefunden</translation>
    </message>
    <message>
        <source>Doubtful thing</source>
        <translation>Zweifelhaftes</translation>
    </message>
    <message>
        <source>What is smaller, from corner to corner or in area, counts only once it was seen in nearly every frame for a while (falling leaves are not); 0: all counts at once</source>
        <translation>Was kleiner ist, von Ecke zu Ecke oder als Fläche, zählt erst, wenn es eine Weile in fast jedem Bild zu sehen war (fallende Blätter sind das nicht); 0: alles zählt sofort</translation>
    </message>
    <message>
        <source>Smooth depth</source>
        <translation>Tiefe glätten</translation>
    </message>
    <message>
        <source>Width of the neighbourhood over which noisy depth of a depth camera or a recorded cloud is averaged; below 3 it is taken as it is</source>
        <translation>Breite der Nachbarschaft, über die verrauschte Tiefe einer Tiefenkamera oder einer aufgezeichneten Punktwolke gemittelt wird; unter 3 bleibt sie, wie sie ist</translation>
    </message>
    <message>
        <source>Steepest</source>
        <translation>Steilste Disparität</translation>
    </message>
    <message>
        <source>A disparity that changes by more than this from pixel to pixel is a veil between a near thing and what is behind it, and goes; 0 is off</source>
        <translation>Eine Disparität, die sich von Pixel zu Pixel um mehr als das ändert, ist ein Schleier zwischen etwas Nahem und dem dahinter und fällt weg; 0 ist aus</translation>
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
        <source>Paused: %1, not what is there now.</source>
        <translation>Angehalten: %1, nicht was jetzt da ist.</translation>
    </message>
    <message>
        <source>End of the recording: %1, not what is there now.</source>
        <translation>Ende der Aufnahme: %1, nicht was jetzt da ist.</translation>
    </message>
    <message>
        <source>%1 is lost. Play opens it again.</source>
        <translation>%1 ist verloren. Abspielen öffnet sie wieder.</translation>
    </message>
    <message>
        <source>NOTHING OPEN</source>
        <translation>NICHTS OFFEN</translation>
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
        <source>Opening %1... Until then, %2 goes on.</source>
        <translation>%1 wird geöffnet... Bis dahin läuft %2 weiter.</translation>
    </message>
    <message>
        <source>Opening %1...</source>
        <translation>%1 wird geöffnet...</translation>
    </message>
    <message>
        <source>Nothing is open. Choose a source, or drop a recording here.</source>
        <translation>Nichts ist offen. Eine Quelle wählen oder eine Aufnahme hierher ziehen.</translation>
    </message>
    <message>
        <source>Rebuilding the model...</source>
        <translation>Das Modell wird neu aufgebaut...</translation>
    </message>
    <message>
        <source>The model is rebuilt with the next frame. </source>
        <translation>Das Modell wird mit dem nächsten Bild neu aufgebaut. </translation>
    </message>
</context>
<context>
    <name>Texts</name>
    <message>
        <source>No picture arrives</source>
        <translation>Kein Bild kommt an</translation>
    </message>
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
        <source>Model is building</source>
        <translation>Modell entsteht</translation>
    </message>
    <message>
        <source>Nothing seen here</source>
        <translation>Hier nichts gesehen</translation>
    </message>
    <message>
        <source>Nothing has arrived from the source. Check camera and cable, or press play.</source>
        <translation>Von der Quelle ist nichts angekommen. Kamera und Kabel prüfen oder abspielen.</translation>
    </message>
    <message>
        <source>The source could not read this frame. Check the recording or the camera.</source>
        <translation>Die Quelle konnte dieses Bild nicht lesen. Aufnahme oder Kamera prüfen.</translation>
    </message>
    <message>
        <source>The source repeats one picture. Check the camera, then reopen it.</source>
        <translation>Die Quelle wiederholt ein Bild. Kamera prüfen, dann neu öffnen.</translation>
    </message>
    <message>
        <source>Too few pixels have a depth. Check light, lenses and calibration.</source>
        <translation>Zu wenige Bildpunkte haben eine Tiefe. Licht, Objektive und Kalibrierung prüfen.</translation>
    </message>
    <message>
        <source>The picture moves as a whole. Hold the camera still and wait.</source>
        <translation>Das Bild bewegt sich als Ganzes. Kamera ruhig halten und warten.</translation>
    </message>
    <message>
        <source>Nobody has said where the load is. Draw a box around the tool that holds it, or set it among the parameters.</source>
        <translation>Niemand hat gesagt, wo die Last ist. Ziehen Sie einen Rahmen um das Werkzeug, das sie hält, oder geben Sie sie bei den Parametern an.</translation>
    </message>
    <message>
        <source>The load is not inside the bounds. Move it or widen the bounds.</source>
        <translation>Die Last ist nicht innerhalb der Grenzen. Bewegen oder die Grenzen weiten.</translation>
    </message>
    <message>
        <source>Too few frames so far. Wait a moment; if it stays so, lower probtresh.</source>
        <translation>Bisher zu wenige Bilder. Kurz warten; bleibt es so, probtresh senken.</translation>
    </message>
    <message>
        <source>Nothing around the load was ever seen. Turn the camera towards it.</source>
        <translation>Um die Last wurde nie etwas gesehen. Die Kamera darauf richten.</translation>
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
        <translation>Freiraum</translation>
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
        <source>never observed</source>
        <translation>nie gesehen</translation>
    </message>
    <message>
        <source>observed free</source>
        <translation>frei gesehen</translation>
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
        <source>Boom and load are not taken out of the cloud. Bring the tool into sight, or draw its box anew.</source>
        <translation>Ausleger und Last werden nicht aus der Wolke genommen. Bringen Sie das Werkzeug in Sicht oder zeichnen Sie seinen Rahmen neu.</translation>
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
        <source>Nothing was found, but the search ends before caution begins. Raise radius or range.</source>
        <translation>Nichts gefunden, aber die Suche endet, bevor die Vorsicht beginnt. Erhöhen Sie Radius oder Reichweite.</translation>
    </message>
    <message>
        <source>No tool</source>
        <translation>Kein Werkzeug</translation>
    </message>
    <message>
        <source>Nobody has said where the tool is, and the load is found at it. Draw a box around the tool in the camera picture.</source>
        <translation>Niemand hat gesagt, wo das Werkzeug ist, an dem die Last gefunden wird. Ziehen Sie im Kamerabild einen Rahmen um das Werkzeug.</translation>
    </message>
    <message>
        <source>Load not seen</source>
        <translation>Last nicht zu sehen</translation>
    </message>
    <message>
        <source>The load is not seen at the tool. Turn the tool, or give its sizes.</source>
        <translation>Die Last ist am Werkzeug nicht zu sehen. Drehen Sie das Werkzeug oder geben Sie ihre Maße an.</translation>
    </message>
    <message>
        <source>It is not known where the tool is.</source>
        <translation>Es ist nicht bekannt, wo das Werkzeug ist.</translation>
    </message>
    <message>
        <source>Nothing was measured at the tool.</source>
        <translation>Am Werkzeug wurde nichts gemessen.</translation>
    </message>
    <message>
        <source>What is at the tool is the ground or a wall.</source>
        <translation>Was am Werkzeug ist, ist der Boden oder eine Wand.</translation>
    </message>
    <message>
        <source>Nothing reaches out of the tool: it is empty.</source>
        <translation>Nichts ragt aus dem Werkzeug: Es ist leer.</translation>
    </message>
    <message>
        <source>The load points at the camera.</source>
        <translation>Die Last zeigt auf die Kamera.</translation>
    </message>
    <message>
        <source>An end of the load is hidden.</source>
        <translation>Ein Ende der Last ist verdeckt.</translation>
    </message>
    <message>
        <source>Only one face of the load is seen.</source>
        <translation>Von der Last ist nur eine Seite zu sehen.</translation>
    </message>
    <message>
        <source>Too few points on the load.</source>
        <translation>Zu wenige Punkte auf der Last.</translation>
    </message>
    <message>
        <source>What is at the tool does not have the shape of a load.</source>
        <translation>Was am Werkzeug ist, hat nicht die Form einer Last.</translation>
    </message>
    <message>
        <source>What is at the tool is too large for a load.</source>
        <translation>Was am Werkzeug ist, ist zu groß für eine Last.</translation>
    </message>
    <message>
        <source>The load is not inside the bounds.</source>
        <translation>Die Last liegt nicht in den Grenzen.</translation>
    </message>
    <message>
        <source>load</source>
        <translation>Last</translation>
    </message>
    <message>
        <source>Tool not seen</source>
        <translation>Werkzeug nicht zu sehen</translation>
    </message>
    <message>
        <source>Tool or boom are watched, but not found in the cloud. Track the tool, or watch the load alone.</source>
        <translation>Werkzeug oder Ausleger werden überwacht, sind aber in der Wolke nicht zu finden. Das Werkzeug verfolgen, oder nur die Last überwachen.</translation>
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
        <source>%1: nothing in range</source>
        <translation>%1: nichts in Reichweite</translation>
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
        <source>Tool not found yet: boom and load are not taken out of the cloud, so there is no distance.</source>
        <translation>Werkzeug noch nicht gefunden: Ausleger und Last werden nicht aus der Wolke genommen, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Tool seen, but not its depth: boom and load are not taken out of the cloud, so there is no distance.</source>
        <translation>Werkzeug gesehen, aber nicht seine Tiefe: Ausleger und Last werden nicht aus der Wolke genommen, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>%1: boom and load are no longer taken out of the cloud, so there is no distance.</source>
        <translation>%1: Ausleger und Last werden nicht mehr aus der Wolke genommen, also gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>Tool seen, but for %1 where it cannot be</source>
        <translation>Werkzeug gesehen, aber seit %1 dort, wo es nicht sein kann</translation>
    </message>
    <message>
        <source>Tool lost and no longer looked for: begin again, or draw a new box. Until then there is no distance.</source>
        <translation>Werkzeug verloren und nicht mehr gesucht: Beginnen Sie neu, oder zeichnen Sie einen neuen Rahmen. Bis dahin gibt es keinen Abstand.</translation>
    </message>
    <message>
        <source>, cannot be there</source>
        <translation>, kann dort nicht sein</translation>
    </message>
    <message>
        <source>Tool lost for %1</source>
        <translation>Werkzeug seit %1 verloren</translation>
    </message>
    <message>
        <source>manual: the click stays where it is</source>
        <translation>manual: der Klick bleibt, wo er ist</translation>
    </message>
    <message>
        <source>tld: learns, finds again, can be saved</source>
        <translation>tld: lernt, findet wieder, kann gespeichert werden</translation>
    </message>
    <message>
        <source>cmt: turns and grows with the tool</source>
        <translation>cmt: dreht sich und wächst mit dem Werkzeug</translation>
    </message>
    <message>
        <source>klt: fast, follows only</source>
        <translation>klt: schnell, folgt nur</translation>
    </message>
    <message>
        <source>csrt: exact, slow, follows only</source>
        <translation>csrt: genau, langsam, folgt nur</translation>
    </message>
    <message>
        <source>Tool found again %1</source>
        <translation>Werkzeug wiedergefunden %1</translation>
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
        <source>The tool is where it was clicked; nothing follows it.</source>
        <translation>Das Werkzeug ist dort, wo geklickt wurde; nichts folgt ihm.</translation>
    </message>
    <message>
        <source>No tool: draw a box around it in the camera picture.</source>
        <translation>Kein Werkzeug: Zeichnen Sie im Kamerabild einen Rahmen darum.</translation>
    </message>
    <message>
        <source>Tool found again, confidence %1.</source>
        <translation>Werkzeug wiedergefunden, Vertrauen %1.</translation>
    </message>
    <message>
        <source>Tool tracked, confidence %1.</source>
        <translation>Werkzeug verfolgt, Vertrauen %1.</translation>
    </message>
    <message>
        <source>Tool seen, but not its depth for %1</source>
        <translation>Werkzeug gesehen, aber seit %1 nicht seine Tiefe</translation>
    </message>
    <message>
        <source>Tool not seen for %1</source>
        <translation>Werkzeug seit %1 nicht gesehen</translation>
    </message>
    <message>
        <source>: taken to be at the load, which is seen. At %1 it counts as lost.</source>
        <translation>: am Ort der Last angenommen, die gesehen wird. Nach %1 gilt es als verloren.</translation>
    </message>
    <message>
        <source>: taken to go on as it moved. At %1 it counts as lost.</source>
        <translation>: Es gilt, dass es sich weiterbewegt wie zuvor. Nach %1 gilt es als verloren.</translation>
    </message>
    <message>
        <source>Learning: this tracker learns nothing.</source>
        <translation>Lernen: Dieser Verfolger lernt nichts.</translation>
    </message>
    <message>
        <source>Learning is off: only what is known by now counts.</source>
        <translation>Lernen ist aus: Es zählt nur, was jetzt bekannt ist.</translation>
    </message>
    <message>
        <source>Learning from what it sees.</source>
        <translation>Lernt aus dem, was er sieht.</translation>
    </message>
    <message>
        <source>Learning is suspended: what is seen is not sure enough to learn from. It goes on by itself.</source>
        <translation>Lernen ist ausgesetzt: Was gesehen wird, ist nicht sicher genug, um daraus zu lernen. Es geht von selbst weiter.</translation>
    </message>
    <message>
        <source>Model: views of the tool %1, of other things %2.</source>
        <translation>Modell: Ansichten des Werkzeugs %1, von anderem %2.</translation>
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
        <source>Drag a box around the tool, or B, arrows and Enter: follow it.
Click, or arrows and Enter: the tool stays here.
Right click or Escape: forget it.</source>
        <translation>Einen Rahmen um das Werkzeug ziehen, oder B, Pfeiltasten und Eingabe: ihm folgen.
Klick, oder Pfeiltasten und Eingabe: Das Werkzeug bleibt hier.
Rechtsklick oder Escape: vergessen.</translation>
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
        <source>nothing within %1 m</source>
        <translation>nichts innerhalb von %1 m</translation>
    </message>
    <message>
        <source>all around it was seen</source>
        <translation>ringsum alles gesehen</translation>
    </message>
    <message>
        <source>%1 % around it never seen: may be nearer</source>
        <translation>%1 % ringsum nie gesehen: kann näher sein</translation>
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
        <source>to space never seen</source>
        <translation>zu nie gesehenem Raum</translation>
    </message>
    <message>
        <source>of the %1</source>
        <translation>vom %1</translation>
    </message>
    <message>
        <source>evidence %1 %</source>
        <translation>Beleg %1 %</translation>
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
        <source>nothing in range</source>
        <translation>nichts in Reichweite</translation>
    </message>
    <message>
        <source>truth: %1</source>
        <translation>wahr: %1</translation>
    </message>
</context>
<context>
    <name>boomwatch::HelpDialog</name>
    <message>
        <source>&lt;h3&gt;What you see&lt;/h3&gt;&lt;p&gt;The bar on the left is the distance from the load to the nearest thing in the model of the surroundings. It begins to fill at the caution distance and is full at a collision. Hatched means that there is no distance; the reason stands beside it.&lt;/p&gt;&lt;p&gt;The point cloud is what the camera measures now: the watched space in green, the load in violet, points taken out as moving in red, and the nearest pair joined by a line. The probability map says how sure the model is of each cell; the environment model shows how far away each one is, nearer being brighter, and hatched where nothing was ever seen.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Was zu sehen ist&lt;/h3&gt;&lt;p&gt;Der Balken links ist der Abstand von der Last zum nächsten Ding im Modell der Umgebung. Er beginnt sich beim Vorsichtsabstand zu füllen und ist bei einer Kollision voll. Schraffiert heißt, dass es keinen Abstand gibt; der Grund steht dabei.&lt;/p&gt;&lt;p&gt;Die Punktwolke ist, was die Kamera jetzt misst: der überwachte Raum in Grün, die Last in Violett, als bewegt herausgenommene Punkte in Rot, und das nächste Punktepaar durch eine Linie verbunden. Die Wahrscheinlichkeitskarte sagt, wie sicher sich das Modell bei jeder Zelle ist; das Umgebungsmodell zeigt, wie weit jede entfernt ist, näher ist heller, und schraffiert ist, was nie gesehen wurde.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Boomwatch: help</source>
        <translation>Boomwatch: Hilfe</translation>
    </message>
    <message>
        <source>&lt;h3&gt;What it does not know&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;What is behind a surface. Each cell holds the surface that is nearest to the camera, nothing behind it.&lt;/li&gt;&lt;li&gt;What was never observed: hidden, too dark, too bright or without texture. The share of the neighbourhood that was observed stands at the bar.&lt;/li&gt;&lt;li&gt;What has only just appeared. A thing must be seen in several frames in a row before it enters the model.&lt;/li&gt;&lt;li&gt;Where the tool is, when it was lost for too long. Then boom and load cannot be taken out of the cloud, and there is no distance.&lt;/li&gt;&lt;li&gt;What is taken out with the load and the boom: shown in red, not in the distance.&lt;/li&gt;&lt;li&gt;Anything, when the camera moves: the model is made for one that stands still.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;A picture that is paused or ended is not what is there now. The words over the bar say so.&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Was es nicht weiß&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;Was hinter einer Fläche ist. Jede Zelle enthält die Fläche, die der Kamera am nächsten ist, nichts dahinter.&lt;/li&gt;&lt;li&gt;Was nie gesehen wurde: verdeckt, zu dunkel, zu hell oder ohne Textur. Der gesehene Anteil der Umgebung steht am Balken.&lt;/li&gt;&lt;li&gt;Was eben erst aufgetaucht ist. Ein Ding muss in mehreren Bildern nacheinander zu sehen sein, bevor es ins Modell gelangt.&lt;/li&gt;&lt;li&gt;Wo das Werkzeug ist, wenn es zu lange verloren war. Dann können Ausleger und Last nicht aus der Wolke genommen werden, und es gibt keinen Abstand.&lt;/li&gt;&lt;li&gt;Was mit Last und Ausleger herausgenommen wird: rot gezeigt, nicht im Abstand enthalten.&lt;/li&gt;&lt;li&gt;Irgendetwas, wenn sich die Kamera bewegt: Das Modell ist für eine gemacht, die stillsteht.&lt;/li&gt;&lt;/ul&gt;&lt;p&gt;Ein Bild, das angehalten oder zu Ende ist, zeigt nicht, was jetzt da ist. Das Wort über dem Balken sagt es.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Keys&lt;/h3&gt;&lt;table cellpadding=&apos;3&apos;&gt;&lt;tr&gt;&lt;td&gt;Space&lt;/td&gt;&lt;td&gt;play or pause&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;. and ,&lt;/td&gt;&lt;td&gt;one frame on, one frame back&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;L&lt;/td&gt;&lt;td&gt;begin again at the end&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ctrl+O&lt;/td&gt;&lt;td&gt;open a recording&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ctrl+S&lt;/td&gt;&lt;td&gt;save a picture of the window&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;R&lt;/td&gt;&lt;td&gt;reset the 3-D view&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;F&lt;/td&gt;&lt;td&gt;fit the maps&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Drag in the camera picture&lt;/td&gt;&lt;td&gt;follow the tool in this box; or B, arrows and Enter&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Click in the camera picture&lt;/td&gt;&lt;td&gt;the tool is here and stays here; right click: it is not&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;h3&gt;Tasten&lt;/h3&gt;&lt;table cellpadding=&apos;3&apos;&gt;&lt;tr&gt;&lt;td&gt;Leertaste&lt;/td&gt;&lt;td&gt;abspielen oder anhalten&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;. und ,&lt;/td&gt;&lt;td&gt;ein Bild weiter, ein Bild zurück&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;L&lt;/td&gt;&lt;td&gt;am Ende von vorn beginnen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Strg+O&lt;/td&gt;&lt;td&gt;eine Aufnahme öffnen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Strg+S&lt;/td&gt;&lt;td&gt;ein Bild des Fensters speichern&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;R&lt;/td&gt;&lt;td&gt;3-D-Ansicht zurücksetzen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;F&lt;/td&gt;&lt;td&gt;Karten einpassen&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Ziehen im Kamerabild&lt;/td&gt;&lt;td&gt;dem Werkzeug in diesem Rahmen folgen; oder B, Pfeiltasten und Eingabe&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;Klick ins Kamerabild&lt;/td&gt;&lt;td&gt;das Werkzeug ist hier und bleibt hier; Rechtsklick: ist es nicht&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Which tracker&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;tld&lt;/b&gt; is the one to begin with: it finds the tool again after it was hidden, learns new views of it, and what it learnt can be saved.&lt;/li&gt;&lt;li&gt;&lt;b&gt;cmt&lt;/b&gt; where the tool has much texture, turns in the picture or is partly covered; not where it is small, blurred or smooth.&lt;/li&gt;&lt;li&gt;&lt;b&gt;csrt&lt;/b&gt; where the computer has time to spare and the tool stays in sight.&lt;/li&gt;&lt;li&gt;&lt;b&gt;klt&lt;/b&gt; for a short while and with little time: once lost, it stays lost.&lt;/li&gt;&lt;/ul&gt;</source>
        <translation>&lt;h3&gt;Welche Verfolgung&lt;/h3&gt;&lt;ul&gt;&lt;li&gt;&lt;b&gt;tld&lt;/b&gt; zuerst: Es findet das Werkzeug wieder, nachdem es verdeckt war, lernt neue Ansichten, und was es gelernt hat, lässt sich speichern.&lt;/li&gt;&lt;li&gt;&lt;b&gt;cmt&lt;/b&gt;, wo das Werkzeug viel Struktur hat, sich im Bild dreht oder teilweise verdeckt ist; nicht, wo es klein, unscharf oder glatt ist.&lt;/li&gt;&lt;li&gt;&lt;b&gt;csrt&lt;/b&gt;, wo der Rechner Zeit übrig hat und das Werkzeug im Bild bleibt.&lt;/li&gt;&lt;li&gt;&lt;b&gt;klt&lt;/b&gt; für kurze Zeit und mit wenig Rechenzeit: Einmal verloren, bleibt es verloren.&lt;/li&gt;&lt;/ul&gt;</translation>
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
        <source>Lost: %1</source>
        <translation>Verloren: %1</translation>
    </message>
    <message>
        <source>Parameters not in force: %1</source>
        <translation>Parameter nicht in Kraft: %1</translation>
    </message>
    <message>
        <source>Frame not used: %1</source>
        <translation>Bild nicht verwendet: %1</translation>
    </message>
    <message>
        <source>The tool is set with the next frame.</source>
        <translation>Das Werkzeug gilt ab dem nächsten Bild.</translation>
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
        <source>%1 cannot be written.</source>
        <translation>%1 kann nicht geschrieben werden.</translation>
    </message>
    <message>
        <source>%1 is not a recording that can be opened. Drop a folder with left and right pictures, with depth pictures, or with PCD or PLY files.</source>
        <translation>%1 ist keine Aufnahme, die geöffnet werden kann. Einen Ordner mit linken und rechten Bildern, mit Tiefenbildern oder mit PCD- oder PLY-Dateien hierher ziehen.</translation>
    </message>
    <message>
        <source>Tool: %1</source>
        <translation>Werkzeug: %1</translation>
    </message>
    <message>
        <source>The calibration does not fit: the rows of left and right differ by %1 px. Calibrate anew, or switch on Refine where it is off.</source>
        <translation>Die Kalibrierung passt nicht: Die Zeilen von links und rechts weichen um %1 px ab. Kalibrieren Sie neu oder schalten Sie Verfeinern ein, wo es aus ist.</translation>
    </message>
    <message>
        <source>The calibration does not fit: the rows of left and right differ by %1 px. That is corrected; better calibrate anew.</source>
        <translation>Die Kalibrierung passt nicht: Die Zeilen von links und rechts weichen um %1 px voneinander ab. Das ist korrigiert; besser neu kalibrieren.</translation>
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
        <source>too small to count</source>
        <translation>zu klein, um zu zählen</translation>
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
        <source>Every parameter back to its default</source>
        <translation>Jeden Parameter auf seinen Standard zurücksetzen</translation>
    </message>
    <message>
        <source>Not in force until these agree: %1</source>
        <translation>Nicht in Kraft, bis diese zusammenpassen: %1</translation>
    </message>
    <message>
        <source>Not in force</source>
        <translation>Nicht in Kraft</translation>
    </message>
    <message>
        <source>At or above the highest probability a cell can reach, p_prior / (1 - p_post) or log_odds_high: nothing enters the model.</source>
        <translation>Auf oder über der höchsten Wahrscheinlichkeit, die eine Zelle erreichen kann, p_prior / (1 - p_post) oder log_odds_high: Nichts gelangt ins Modell.</translation>
    </message>
    <message>
        <source>So low that a cell which is looked through stays occupied: nothing leaves the model.</source>
        <translation>So niedrig, dass eine Zelle, durch die hindurchgesehen wird, belegt bleibt: Nichts verlässt das Modell.</translation>
    </message>
    <message>
        <source>The search ends before the caution distance: where it finds nothing there is no distance, rather than clear.</source>
        <translation>Die Suche endet vor dem Vorsichtsabstand: Wo sie nichts findet, gibt es keinen Abstand statt „frei“.</translation>
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
    <message>
        <source>%1
%2: %3</source>
        <translation>%1
%2: %3</translation>
    </message>
</context>
<context>
    <name>boomwatch::ParameterRow</name>
    <message>
        <source>Back to the default</source>
        <translation>Zurück zum Standard</translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation>%1 zurücksetzen</translation>
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
        <source>One frame back</source>
        <translation>Ein Bild zurück</translation>
    </message>
    <message>
        <source>One frame on</source>
        <translation>Ein Bild weiter</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>Am Ende von vorn beginnen</translation>
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
        <source>Speed of a recording; fastest: as fast as frames can be processed</source>
        <translation>Tempo einer Aufnahme; schnellstens: so schnell, wie Bilder verarbeitet werden können</translation>
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
        <source>LEFT,RIGHT: device numbers or stream addresses, or one of both</source>
        <translation>LINKS,RECHTS: Gerätenummern oder Adressen, oder eine für beide</translation>
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
        <source>&amp;Where</source>
        <translation>&amp;Wo</translation>
    </message>
    <message>
        <source>the one that lies with the recording</source>
        <translation>die, die bei der Aufnahme liegt</translation>
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
        <source>A height or depth map: an ASCII grid, or a YAML file about one</source>
        <translation>Eine Höhen- oder Tiefenkarte: ein ASCII-Gitter, oder eine YAML-Datei darüber</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Maps (*.asc *.yaml *.yml)</source>
        <translation>Karten (*.asc *.yaml *.yml)</translation>
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
        <source>%1 ms frame to bar</source>
        <translation>%1 ms vom Bild zum Balken</translation>
    </message>
    <message>
        <source>not shown %1, lost %2</source>
        <translation>nicht gezeigt %1, verloren %2</translation>
    </message>
    <message>
        <source>Frames that were processed but replaced before they could be shown, and frames of a live source that nobody read</source>
        <translation>Bilder, die verarbeitet, aber ersetzt wurden, bevor sie gezeigt werden konnten, und Bilder einer Live-Quelle, die niemand gelesen hat</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>Milliseconds that this stage took for the last frame</source>
        <translation>Millisekunden, die diese Stufe für das letzte Bild brauchte</translation>
    </message>
    <message>
        <source>Load last seen %1 s ago.</source>
        <translation>Last zuletzt vor %1 s gesehen.</translation>
    </message>
    <message>
        <source>%1 % of the points were taken out with boom, tool and load.</source>
        <translation>%1 % der Punkte wurden mit Ausleger, Werkzeug und Last herausgenommen.</translation>
    </message>
</context>
<context>
    <name>boomwatch::TrackingDock</name>
    <message>
        <source>Models of a tool (*.tool);;All files (*)</source>
        <translation>Modelle eines Werkzeugs (*.tool);;Alle Dateien (*)</translation>
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
        <source>What follows the tool; a new one begins where the old one saw it</source>
        <translation>Was dem Werkzeug folgt; ein neuer beginnt dort, wo der alte es sah</translation>
    </message>
    <message>
        <source>Learn</source>
        <translation>Lernen</translation>
    </message>
    <message>
        <source>tld: go on learning what the tool looks like</source>
        <translation>tld: weiter lernen, wie das Werkzeug aussieht</translation>
    </message>
    <message>
        <source>Draw box</source>
        <translation>Rahmen zeichnen</translation>
    </message>
    <message>
        <source>Begin a box in the camera picture: arrows size it, Enter starts, Escape gives up. Or drag one with the mouse.</source>
        <translation>Einen Rahmen im Kamerabild beginnen: Pfeiltasten ändern seine Größe, Eingabe startet, Escape verwirft. Oder mit der Maus aufziehen.</translation>
    </message>
    <message>
        <source>Begin again</source>
        <translation>Neu beginnen</translation>
    </message>
    <message>
        <source>Begin anew where the tool was last seen; what was learnt since is forgotten</source>
        <translation>Neu beginnen, wo das Werkzeug zuletzt gesehen wurde; was seither gelernt wurde, wird vergessen</translation>
    </message>
    <message>
        <source>Forget</source>
        <translation>Vergessen</translation>
    </message>
    <message>
        <source>Nothing follows the tool any more</source>
        <translation>Nichts folgt dem Werkzeug mehr</translation>
    </message>
    <message>
        <source>Load...</source>
        <translation>Laden...</translation>
    </message>
    <message>
        <source>Find the tool by a saved model; several files are merged. Only tld can.</source>
        <translation>Das Werkzeug mit einem gespeicherten Modell finden; mehrere Dateien werden vereint. Nur tld kann das.</translation>
    </message>
    <message>
        <source>Merge...</source>
        <translation>Vereinen...</translation>
    </message>
    <message>
        <source>Add saved models to what is known by now</source>
        <translation>Gespeicherte Modelle zu dem hinzufügen, was jetzt bekannt ist</translation>
    </message>
    <message>
        <source>Save...</source>
        <translation>Speichern...</translation>
    </message>
    <message>
        <source>Save what is known by now</source>
        <translation>Speichern, was jetzt bekannt ist</translation>
    </message>
    <message>
        <source>Learnt views</source>
        <translation>Gelernte Ansichten</translation>
    </message>
    <message>
        <source>What was learnt last: above, views of the tool; below, of what is not the tool</source>
        <translation>Was zuletzt gelernt wurde: oben Ansichten des Werkzeugs, unten von dem, was nicht das Werkzeug ist</translation>
    </message>
    <message>
        <source>Merge models of the tool</source>
        <translation>Modelle des Werkzeugs vereinen</translation>
    </message>
    <message>
        <source>Load a model of the tool</source>
        <translation>Ein Modell des Werkzeugs laden</translation>
    </message>
    <message>
        <source>Save the model of the tool</source>
        <translation>Das Modell des Werkzeugs speichern</translation>
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
