#pragma once

#include <cstddef>

namespace boomwatch {

/// Numbers of Tracking-Learning-Detection.
///
/// "Kalal": Kalal, Mikolajczyk, Matas, "Tracking-Learning-Detection", PAMI 2012. "OpenTLD": the
/// program its authors published. "Chosen": by judgement; not measured one by one. Their effect
/// together is measured: docs/experiments.md.
struct TldTuning {
  // The scan, pixels and shares of the tool's box.
  double scaleStep = 1.2;    ///< ratio of two successive scales; Kalal, section 5.3
  double strideShare = 0.1;  ///< of a window, from one window to the next; Kalal, section 5.3
  double minWindow = 8.0;    ///< pixels, shorter side of a window; chosen, Kalal has 20
  int allScales = 8;         ///< steps to either side when the tool is away; chosen
  int nearScales = 5;        ///< steps to either side otherwise; chosen
  int imagesAway = 25;       ///< images after which a lost tool may have any scale; chosen
  std::size_t maxCandidates = 100;  ///< windows that pass the ferns; OpenTLD
  std::size_t maxDetections = 5;    ///< places in one image; chosen
  double sameOverlap = 0.5;         ///< of two boxes, from which they are one place; chosen

  // What is the tool. Likeness is relative similarity, 0..1: Kalal, section 5.2.
  double varianceShare = 0.5;    ///< of a patch's variance, below which a window is none; Kalal
  float fernThreshold = 0.5F;    ///< ferns' answer that passes a window on; Kalal, OpenTLD
  float toolThreshold = 0.65F;   ///< relative likeness of the tool; OpenTLD, Kalal has 0.6
  double olderHalf = 0.5;        ///< of the patches: those of conservative likeness; Kalal
  float trustedLikeness = 0.7F;  ///< conservative likeness that may be learnt; OpenTLD
  float doubtedLikeness = 0.5F;  ///< likeness below which a followed box is doubted; OpenTLD
  int maxDoubt = 25;             ///< images in doubt after which the tool is lost; chosen
  float somethingElse = 0.45F;   ///< likeness below which a place was learnt as no tool; chosen
  float lead = 0.05F;            ///< of the likeliest place before the second; chosen
  std::size_t maxSharpened = 5;  ///< places that are refined while the tool is lost; chosen

  // Flow and detections together.
  double sureFlow = 0.93;        ///< NCC below which patches say where the box is; chosen
  double refinedShare = 0.5;     ///< of the way that patches then move the box; chosen
  double minShareInside = 0.5;   ///< of a box, inside the picture; chosen
  double flatShare = 0.25;       ///< of varianceShare's limit: a wall before the tool; chosen
  double mixOverlap = 0.7;       ///< of a detection with the flow, to be mixed in; OpenTLD
  double mixShare = 3.0 / 13.0;  ///< of a detection in the mix; chosen, OpenTLD has 1 in 11

  // Refining a box. All chosen.
  double firstStep = 0.08;  ///< of the box
  double lastStep = 0.02;   ///< of the box
  int roundsPerStep = 2;
  float minRefined = 0.85F;  ///< NCC as likeness, below which the box stays where it was

  // Learning. Warps are of the ferns' patches.
  int firstWarps = 200;       ///< from the first image; Kalal
  double firstAngle = 10.0;   ///< degrees; Kalal
  int laterWarps = 20;        ///< from each later image; chosen, Kalal has 100
  double laterAngle = 5.0;    ///< degrees; Kalal
  double warpShift = 0.07;    ///< of the box: half of what lies between two windows and scales
  double warpScale = 0.1;     ///< half of what lies between two scales
  int firstScans = 4;         ///< scans of the first image for what is not the tool; chosen
  float newPositive = 0.75F;  ///< likeness below which a patch of the tool is new; chosen
  float newNegative = 0.5F;   ///< likeness above which a patch elsewhere is new; OpenTLD
  float minLikeness = 0.5F;   ///< of a box that may be learnt; OpenTLD
  double elsewhere = 0.2;     ///< overlap below which a window is not the tool; OpenTLD
  double minVariance = 0.25;  ///< grey levels squared: below, all pixels of a box are equal

  // Cutting patches.
  double cutMargin = 0.5;     ///< of the box, around it on each side: room for warps
  double oversampling = 2.0;  ///< pixels along a side for one of the patch
  double cutBlur = 1.55;      ///< of these pixels: as sharp as the scan's, smoothed by 1 2 1

  // Colours; see ColourLayout. All chosen.
  int coloursEvery = 3;     ///< images from one question to the next while all is sure
  double farAhead = 0.15;   ///< of another place's score, to be believed against a sure box
  double justAhead = 0.05;  ///< the same against a box that is not sure
};

}  // namespace boomwatch
