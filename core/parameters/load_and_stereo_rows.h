#pragma once

#include "parameters/row_names.h"

/// Rows of load, tracking, cloud filter, stereo and validity. Only for parameter_table.cpp.
namespace boomwatch::table_row {

inline constexpr auto loadAndStereoRows = std::to_array<ParameterInfo>({
    row<&P::load, &L::source>("load_source",
                              {TR("Load"), TR("Load source"),
                               TR("auto: detected when a tool is tracked or the source gives one, "
                                  "otherwise from the source. scene: only from the source. manual: "
                                  "the values below. detected: found at the tool in every frame.")},
                              {}, loadNames),
    row<&P::load, &L::x>(
        "load_x",
        {TR("Load"), TR("Centre x"), TR("Centre of the load, to the right of the camera."), "m"},
        coordinate),
    row<&P::load, &L::y>(
        "load_y", {TR("Load"), TR("Centre y"), TR("Centre of the load, below the camera."), "m"},
        coordinate),
    row<&P::load, &L::z>(
        "load_z",
        {TR("Load"), TR("Centre z"), TR("Centre of the load, in front of the camera."), "m"},
        coordinate),
    row<&P::load, &L::sizeX>(
        "load_size_x",
        {TR("Load"), TR("Size x"),
         TR("Full size along the x axis of the load; of a log its length."), "m"},
        loadSize),
    row<&P::load, &L::sizeY>(
        "load_size_y",
        {TR("Load"), TR("Size y"), TR("Full size along the y axis of the load."), "m"}, loadSize),
    row<&P::load, &L::sizeZ>(
        "load_size_z",
        {TR("Load"), TR("Size z"), TR("Full size along the z axis of the load."), "m"}, loadSize),
    row<&P::load, &L::yaw>("load_yaw", {TR("Load"), TR("Yaw"), TR("First rotation, about y."), "°"},
                           angle),
    row<&P::load, &L::pitch>(
        "load_pitch", {TR("Load"), TR("Pitch"), TR("Second rotation, about x."), "°"}, angle),
    row<&P::load, &L::roll>("load_roll",
                            {TR("Load"), TR("Roll"), TR("Third rotation, about z."), "°"}, angle),
    row<&P::load, &L::shape>("load_shape",
                             {TR("Load"), TR("Shape"),
                              TR("Shape of a detected load. cylinder: a log. box: a box. auto: a "
                                 "log, or a box where no log fits.")},
                             {}, shapeNames),
    row<&P::load, &L::dimensions>(
        "load_dimensions",
        {TR("Load"), TR("Dimensions"),
         TR("Sizes of a detected load. learnt: learnt at first, then improved by frames that show "
            "them better. locked: the sizes above.")},
        {}, dimensionNames),
    row<&P::load, &L::learnTime>("load_learn_time",
                                 {TR("Load"), TR("Learning time"),
                                  TR("How long the sizes of a detected load are learnt. With a "
                                     "higher value more frames are averaged. Usual: 1 to 5 s."),
                                  "s"},
                                 {0, 60, 0.5}),
    row<&P::load, &L::maxSize>(
        "load_max_size",
        {TR("Load"), TR("Maximum load size"),
         TR("A longer body at the tool is rejected as load. With a higher value longer loads are "
            "detected. Set it somewhat above the longest load. Usual: 2 to 10 m."),
         "m"},
        {0.05, 100, 0.5}),
    row<&P::load, &L::toolSize>(
        "load_tool_size",
        {TR("Load"), TR("Tool diameter"),
         TR("Points within half of this of the tool point belong to the tool, not to the load. "
            "With a higher value more points belong to the tool. Usual: 0.3 to 1.5 m."),
         "m"},
        {0, 20, 0.1}),
    row<&P::load, &L::margin>(
        "load_margin",
        {TR("Load"), TR("Mask margin"),
         TR("Points this close to a detected load are masked with it. With a higher value more "
            "points are masked. Any other load has a margin of one cell. Usual: 0.05 to 0.2 m."),
         "m"},
        {0, 10, 0.05}),
    row<&P::tracking, &TP::tracker>(
        "tracker",
        {TR("Tracking"), TR("Tracker"),
         TR("tld: learns, re-detects the tool and can be saved. cmt: tracks rotation and changes "
            "of size. csrt: accurate and slow, no re-detection. klt: fast, no re-detection. "
            "manual: the clicked pixel stays.")},
        {}, trackerNames),
    row<&P::tracking, &TP::learn>("learn", {TR("Tracking"), TR("Learn"),
                                            TR("tld: learn new views of the tool while tracking. "
                                               "Off: use only the views learnt so far.")}),
    row<&P::tracking, &TP::toolPoint>(
        "tool_point",
        {TR("Tracking"), TR("Tool point"),
         TR("right: the measured pixel at the centre of the box, or the next one to its right. "
            "near: a near point in the middle of the box, for a grapple with gaps.")},
        {}, toolPointNames),
    row<&P::tracking, &TP::maxToolAge>(
        "max_tool_age",
        {TR("Tracking"), TR("Maximum tool age"),
         TR("How long the tool may be out of sight. Until then its position is extrapolated; after "
            "that no distance is shown. Usual: 0.3 to 1 s."),
         "s"},
        {0.05, 10, 0.1}),
    row<&P::tracking, &TP::noise>("tool_noise",
                                  {TR("Tracking"), TR("Tool point noise"),
                                   TR("Standard deviation of the measured tool point. A higher "
                                      "value smooths more and reacts later. Usual: 0.02 to 0.1 m."),
                                   "m"},
                                  {0.001, 1, 0.01}),
    row<&P::tracking, &TP::acceleration>(
        "tool_acceleration",
        {TR("Tracking"), TR("Tool acceleration"),
         TR("How quickly the tool may change its velocity. A higher value smooths less and reacts "
            "sooner. Usual: 1 to 5 m/s²."),
         "m/s²"},
        {0.1, 100, 0.5}),
    row<&P::tracking, &TP::maxSpeed>(
        "tool_speed",
        {TR("Tracking"), TR("Maximum tool speed"),
         TR("Maximum speed of the tool. A tracker that jumps farther is rejected and must "
            "re-detect the tool. A higher value rejects fewer jumps. Usual: 3 to 10 m/s."),
         "m/s"},
        {0.1, 1000, 0.5}),
    row<&P::filter, &F::zReprojection>(
        "z_reprojection",
        {TR("Filter"), TR("Fixed depth (z_reprojection)"),
         TR("Moves every kept point to this z. off: points keep their depth."), "m"},
        coordinate),
    row<&P::filter, &F::lowPass>("low_pass", {TR("Filter"), TR("Outlier removal (low_pass)"),
                                              TR("Removes isolated points from the cloud. Slow.")}),
    row<&P::filter, &F::lowPassMethod>(
        "low_pass_method",
        {TR("Filter"), TR("Outlier method"),
         TR("statistical: removes points that are unusually far from their neighbours. radius: "
            "removes points with too few neighbours.")},
        {}, lowPassNames),
    row<&P::filter, &F::lowPassNeighbours>(
        "low_pass_neighbours",
        {TR("Filter"), TR("Number of neighbours"),
         TR("statistical: nearest neighbours that each point is compared with. A higher value "
            "judges a larger area and is slower. Usual: 8 to 50.")},
        {1, 200, 1}),
    row<&P::filter, &F::lowPassDeviations>(
        "low_pass_deviations",
        {TR("Filter"), TR("Allowed deviations"),
         TR("statistical: standard deviations above the mean distance at which a point is removed. "
            "A higher value removes fewer points. Usual: 1 to 3.")},
        {0.01, 10, 0.1}),
    row<&P::filter, &F::lowPassRadius>(
        "low_pass_radius",
        {TR("Filter"), TR("Neighbour radius"),
         TR("radius: how far a neighbour may be from a point. A higher value removes fewer points. "
            "Usual: 0.05 to 0.3 m."),
         "m"},
        {0.001, 10, 0.01}),
    row<&P::filter, &F::lowPassMinimum>("low_pass_minimum",
                                        {TR("Filter"), TR("Minimum neighbours"),
                                         TR("radius: neighbours that a point needs. A higher value "
                                            "removes more points. Usual: 2 to 10.")},
                                        {1, 200, 1}),
    row<&P::filter, &F::clusterTolerance>(
        "cluster_tolerance",
        {TR("Filter"), TR("Cluster tolerance"),
         TR("Points closer together than this form one cluster. With a higher value more objects "
            "join, such as tool and ground. Usual: 0.05 to 0.2 m."),
         "m"},
        {0.001, 10, 0.01}),
    row<&P::filter, &F::depthSmooth>(
        "depth_smooth",
        {TR("Filter"), TR("Depth smoothing"),
         TR("Width of the window that averages noisy depth of a depth camera or a recorded cloud. "
            "A higher value smooths more. Below 3: off. Usual: 3 to 9 pixels."),
         "pixels"},
        {0, 31, 2}),
    row<&P::filter, &F::clusterMinimum>(
        "cluster_minimum",
        {TR("Filter"), TR("Minimum cluster size"),
         TR("Clusters with fewer points are removed as noise. A higher value removes more noise "
            "but also small objects. Usual: 10 to 50 points."),
         "points"},
        {1, 100000, 5}),
    row<&P::stereo, &S::matcher>(
        "stereo_matcher",
        {TR("Stereo"), TR("Stereo matcher"),
         TR("sgbm: semi-global matching, dense. bm: block matching, faster but sparser.")},
        {}, matcherNames),
    row<&P::stereo, &S::minDisparity>("stereo_min_disparity",
                                      {TR("Stereo"), TR("Minimum disparity"),
                                       TR("Disparity at which the search begins. With a higher "
                                          "value distant objects are ignored. Usual: 0 px."),
                                       "px"},
                                      {-512, 512, 1}),
    row<&P::stereo, &S::disparities>(
        "stereo_disparities",
        {TR("Stereo"), TR("Number of disparities"),
         TR("Disparities that are searched, a multiple of 16. A higher value measures nearer "
            "objects and takes longer. Usual: 64 to 256 px."),
         "px"},
        {16, 1024, 16}),
    row<&P::stereo, &S::blockSize>(
        "stereo_block_size",
        {TR("Stereo"), TR("Block size"),
         TR("Side of the matched block, an odd number. A higher value gives less noise but coarser "
            "edges. bm needs at least 5, sgbm at most 15. Usual: 3 to 11 px."),
         "px"},
        {1, 51, 2}),
    row<&P::stereo, &S::uniqueness>(
        "stereo_uniqueness",
        {TR("Stereo"), TR("Uniqueness"),
         TR("Margin by which the best match must beat the second best. A higher value rejects more "
            "ambiguous matches. Usual: 5 to 15 %."),
         "%"},
        {0, 99, 1}),
    row<&P::stereo, &S::consistency>(
        "stereo_consistency",
        {TR("Stereo"), TR("Left-right check"),
         TR("Maximum difference between the matches from left to right and from right to left. A "
            "higher value rejects fewer occluded pixels. -1: off. Usual: 1 to 2 px."),
         "px"},
        {-1, 100, 1}),
    row<&P::stereo, &S::speckleWindow>(
        "stereo_speckle_window",
        {TR("Stereo"), TR("Minimum speckle size"),
         TR("Smaller connected components of the disparity are removed. A higher value removes "
            "more noise but also small objects. 0: off. Usual: 50 to 200 px."),
         "px"},
        {0, 10000, 10}),
    row<&P::stereo, &S::speckleRange>(
        "stereo_speckle_range",
        {TR("Stereo"), TR("Maximum speckle step"),
         TR("Maximum step of disparity inside a connected component. With a higher value more "
            "pixels are joined. Usual: 1 to 2 px."),
         "px"},
        {0, 100, 1}),
    row<&P::stereo, &S::preFilterCap>(
        "stereo_prefilter_cap",
        {TR("Stereo"), TR("Prefilter cap"),
         TR("Limit of the image gradient before matching. With a higher value strong edges weigh "
            "more. Usual: 15 to 63.")},
        {1, 63, 1}),
    row<&P::stereo, &S::texture>("stereo_texture",
                                 {TR("Stereo"), TR("Minimum texture"),
                                  TR("Areas with a lower mean gradient are not matched, such as "
                                     "over-exposed, dark or blank ones. A higher value leaves more "
                                     "areas without depth. 0: off. Usual: 0.1 to 0.5 grey/px."),
                                  "grey/px"},
                                 {0, 50, 0.1}),
    row<&P::stereo, &S::average>(
        "stereo_average",
        {TR("Stereo"), TR("Frames averaged"),
         TR("Frames over which disparity is averaged. For a static camera. A higher value gives "
            "less noise, but small changes appear 4 frames later. 1: off. Usual: 1 to 20 frames."),
         "frames"},
        {1, 200, 5}),
    row<&P::stereo, &S::refine>(
        "stereo_refine", {TR("Stereo"), TR("Row correction (stereo_refine)"),
                          TR("Corrects a calibration whose rows of left and right differ. Rotates "
                             "the right camera by up to one degree and adapts its focal length.")}),
    row<&P::stereo, &S::smooth>(
        "stereo_smooth",
        {TR("Stereo"), TR("Disparity smoothing"),
         TR("Width of the window over which similar disparities are averaged. A higher value "
            "smooths more and takes longer. 0: off. Usual: 5 to 31 px."),
         "px"},
        {0, 99, 10}),
    row<&P::stereo, &S::maxSlope>(
        "stereo_steepest",
        {TR("Stereo"), TR("Maximum disparity slope"),
         TR("Pixels whose disparity changes by more than this per pixel are removed as flying "
            "pixels. A higher value removes fewer. 0: off. Usual: 0.4 to 1 px/px."),
         "px/px"},
        {0, 100, 0.1}),
    row<&P::validity, &V::maxFrameAge>(
        "max_frame_age",
        {TR("Validity"), TR("Maximum frame age"),
         TR("How long the source may deliver no frame. After that no distance is shown. A higher "
            "value tolerates longer gaps. Usual: 0.3 to 1 s."),
         "s"},
        {0.05, 60, 0.1}),
    row<&P::validity, &V::identicalFrames>(
        "identical_frames",
        {TR("Validity"), TR("Frozen after"),
         TR("Identical frames in a row after which the source is reported as frozen. A higher "
            "value reports it later. Usual: 3 to 10 frames."),
         "frames"},
        {2, 1000, 1}),
    row<&P::validity, &V::minFill>(
        "min_fill",
        {TR("Validity"), TR("Minimum depth coverage"),
         TR("Share of the pixels that must have a depth. Below it no distance is shown. A higher "
            "value is stricter. Usual: 0.05 to 0.3.")},
        {0, 1, 0.01}),
    row<&P::validity, &V::sceneMotion>(
        "scene_motion",
        {TR("Validity"), TR("Camera motion limit"),
         TR("Share of the picture that may move. Above it the camera is assumed to move, and no "
            "distance is shown. A higher value is more tolerant. 1: off. Usual: 0.5 to 0.8.")},
        {0.05, 1, 0.05}),
    row<&P::validity, &V::maxLoadAge>(
        "max_load_age",
        {TR("Validity"), TR("Maximum load age"),
         TR("How long a detected load may be out of sight. Until then its position is "
            "extrapolated; after that no distance is shown. Usual: 0.3 to 1 s."),
         "s"},
        {0, 60, 0.1}),
    row<&P::validity, &V::minObserved>(
        "min_observed",
        {TR("Validity"), TR("Minimum observed share"),
         TR("Share of the load's neighbourhood that must have been observed. Below it no distance "
            "is shown. A higher value is stricter. Usual: 0.1 to 0.5.")},
        {0.01, 1, 0.05}),
});

}  // namespace boomwatch::table_row
