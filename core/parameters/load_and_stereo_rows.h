#pragma once

#include "parameters/row_names.h"

/// The rows of what is sensed, followed and filtered; only for parameter_table.cpp.
namespace boomwatch::table_row {

inline constexpr auto sensingRows = std::to_array<ParameterInfo>({
    row<&P::load, &L::source>("load_source",
                              {TR("Load"), TR("Load given by"),
                               TR("auto: detected where a tool is followed or the source has one, "
                                  "else what the source knows; scene: only what the source itself "
                                  "knows; manual: the values below; detected: found in every "
                                  "frame, at the tool")},
                              {}, loadNames),
    row<&P::load, &L::x>(
        "load_x",
        {TR("Load"), TR("Centre x"), TR("Centre of the load, to the right of the camera"), "m"},
        coordinate),
    row<&P::load, &L::y>(
        "load_y", {TR("Load"), TR("Centre y"), TR("Centre of the load, below the camera"), "m"},
        coordinate),
    row<&P::load, &L::z>(
        "load_z",
        {TR("Load"), TR("Centre z"), TR("Centre of the load, in front of the camera"), "m"},
        coordinate),
    row<&P::load, &L::sizeX>(
        "load_size_x", {TR("Load"), TR("Size x"), TR("Full size along the load's own x"), "m"},
        loadSize),
    row<&P::load, &L::sizeY>(
        "load_size_y", {TR("Load"), TR("Size y"), TR("Full size along the load's own y"), "m"},
        loadSize),
    row<&P::load, &L::sizeZ>(
        "load_size_z", {TR("Load"), TR("Size z"), TR("Full size along the load's own z"), "m"},
        loadSize),
    row<&P::load, &L::yaw>("load_yaw", {TR("Load"), TR("Yaw"), TR("Turn about y, first"), "°"},
                           angle),
    row<&P::load, &L::pitch>("load_pitch",
                             {TR("Load"), TR("Pitch"), TR("Turn about x, second"), "°"}, angle),
    row<&P::load, &L::roll>("load_roll", {TR("Load"), TR("Roll"), TR("Turn about z, third"), "°"},
                            angle),
    row<&P::load, &L::shape>(
        "load_shape",
        {TR("Load"), TR("Shape"), TR("detected: a log, a box, or a box where there is no log")}, {},
        shapeNames),
    row<&P::load, &L::dimensions>(
        "load_dimensions",
        {TR("Load"), TR("Sizes"),
         TR("detected: learnt at first, then held until seen better, or locked to the sizes above "
            "(x is a log's length)")},
        {}, dimensionNames),
    row<&P::load, &L::learnTime>(
        "load_learn_time",
        {TR("Load"), TR("Learning time"), TR("detected: over which the sizes are learnt"), "s"},
        {0, 60, 0.5}),
    row<&P::load, &L::maxSize>(
        "load_max_size",
        {TR("Load"), TR("Largest size"), TR("detected: what is longer is no load"), "m"},
        {0.05, 100, 0.5}),
    row<&P::load, &L::toolSize>("load_tool_size",
                                {TR("Load"), TR("Tool size"),
                                 TR("detected: what is nearer than half of this to the tool point "
                                    "is the tool, not the load"),
                                 "m"},
                                {0, 20, 0.1}),
    row<&P::load, &L::margin>(
        "load_margin",
        {TR("Load"), TR("Margin"),
         TR("detected: points so near to the load are taken out with it; else one cell"), "m"},
        {0, 10, 0.05}),
    row<&P::tracking, &TP::tracker>(
        "tracker",
        {TR("Tracking"), TR("Tracker"),
         TR("tld: learns, finds again, can be saved; cmt: turns and grows with the tool; klt and "
            "csrt: follow only; manual: the click stays where it is")},
        {}, trackerNames),
    row<&P::tracking, &TP::learn>(
        "learn", {TR("Tracking"), TR("Learn"),
                  TR("tld: go on learning what the tool looks like; off: only what is known")}),
    row<&P::tracking, &TP::toolPoint>(
        "tool_point",
        {TR("Tracking"), TR("Tool point"),
         TR("right: the box's centre or the next measured pixel on its right; near: what is near "
            "in the middle of the box, for a grapple that can be seen through")},
        {}, toolPointNames),
    row<&P::tracking, &TP::maxToolAge>(
        "max_tool_age",
        {TR("Tracking"), TR("Tool age"),
         TR("Longer without the tool, and there is no distance; until then it is taken to go on "
            "as it moved"),
         "s"},
        {0.05, 10, 0.1}),
    row<&P::tracking, &TP::noise>(
        "tool_noise",
        {TR("Tracking"), TR("Tool noise"),
         TR("Standard deviation of the tool's point as measured; more is smoother"), "m"},
        {0.001, 1, 0.01}),
    row<&P::tracking, &TP::acceleration>(
        "tool_acceleration",
        {TR("Tracking"), TR("Tool acceleration"),
         TR("How quickly the tool changes its velocity; less is smoother"), "m/s²"},
        {0.1, 100, 0.5}),
    row<&P::tracking, &TP::maxSpeed>(
        "tool_speed",
        {TR("Tracking"), TR("Tool speed"),
         TR("The fastest the tool can move; a tracker that leaps further follows something else, "
            "and must look for the tool again"),
         "m/s"},
        {0.1, 1000, 0.5}),
    row<&P::filter, &F::zReprojection>(
        "z_reprojection",
        {TR("Filter"), TR("z reprojection"), TR("Move every kept point to this z"), "m"},
        coordinate),
    row<&P::filter, &F::lowPass>("low_pass",
                                 {TR("Filter"), TR("Low pass"), TR("Remove outliers; slow")}),
    row<&P::filter, &F::lowPassMethod>(
        "low_pass_method",
        {TR("Filter"), TR("Low pass method"),
         TR("statistical: by mean distance to the neighbours; radius: by number of neighbours")},
        {}, lowPassNames),
    row<&P::filter, &F::lowPassNeighbours>(
        "low_pass_neighbours",
        {TR("Filter"), TR("Neighbours"), TR("statistical: neighbours looked at")}, {1, 200, 1}),
    row<&P::filter, &F::lowPassDeviations>(
        "low_pass_deviations",
        {TR("Filter"), TR("Deviations"), TR("statistical: standard deviations allowed")},
        {0.01, 10, 0.1}),
    row<&P::filter, &F::lowPassRadius>(
        "low_pass_radius",
        {TR("Filter"), TR("Neighbour radius"), TR("radius: how far a neighbour may be"), "m"},
        {0.001, 10, 0.01}),
    row<&P::filter, &F::lowPassMinimum>(
        "low_pass_minimum",
        {TR("Filter"), TR("Neighbours needed"), TR("radius: neighbours a point must have")},
        {1, 200, 1}),
    row<&P::filter, &F::clusterTolerance>(
        "cluster_tolerance",
        {TR("Filter"), TR("Cluster tolerance"), TR("Points nearer than this belong together"), "m"},
        {0.001, 10, 0.01}),
    row<&P::filter, &F::depthSmooth>(
        "depth_smooth",
        {TR("Filter"), TR("Smooth depth"),
         TR("Width of the neighbourhood over which noisy depth of a depth camera or a recorded "
            "cloud is averaged; below 3 it is taken as it is"),
         "pixels"},
        {0, 31, 2}),
    row<&P::filter, &F::clusterMinimum>(
        "cluster_minimum",
        {TR("Filter"), TR("Cluster minimum"), TR("Smaller clusters are noise and go"), "points"},
        {1, 100000, 5}),
    row<&P::stereo, &S::matcher>(
        "stereo_matcher",
        {TR("Stereo"), TR("Matcher"),
         TR("sgbm: semi-global, 3-way; bm: block matching, faster and sparser")},
        {}, matcherNames),
    row<&P::stereo, &S::minDisparity>(
        "stereo_min_disparity",
        {TR("Stereo"), TR("Smallest disparity"), TR("Disparity at which the search begins"), "px"},
        {-512, 512, 1}),
    row<&P::stereo, &S::disparities>(
        "stereo_disparities",
        {TR("Stereo"), TR("Disparities"),
         TR("Disparities searched, a multiple of 16; more sees nearer"), "px"},
        {16, 1024, 16}),
    row<&P::stereo, &S::blockSize>(
        "stereo_block_size",
        {TR("Stereo"), TR("Block size"), TR("Side of the matched block, odd; bm needs at least 5"),
         "px"},
        {1, 51, 2}),
    row<&P::stereo, &S::uniqueness>("stereo_uniqueness",
                                    {TR("Stereo"), TR("Uniqueness"),
                                     TR("By how much the best match must beat the second"), "%"},
                                    {0, 99, 1}),
    row<&P::stereo, &S::consistency>(
        "stereo_consistency",
        {TR("Stereo"), TR("Consistency"),
         TR("Difference allowed between left and right; -1 is off"), "px"},
        {-1, 100, 1}),
    row<&P::stereo, &S::speckleWindow>("stereo_speckle_window",
                                       {TR("Stereo"), TR("Speckle window"),
                                        TR("Smaller connected pieces are removed; 0 is off"), "px"},
                                       {0, 10000, 10}),
    row<&P::stereo, &S::speckleRange>(
        "stereo_speckle_range",
        {TR("Stereo"), TR("Speckle range"), TR("Disparity step inside a piece"), "px"},
        {0, 100, 1}),
    row<&P::stereo, &S::preFilterCap>(
        "stereo_prefilter_cap",
        {TR("Stereo"), TR("Prefilter cap"), TR("Truncation of the gradient before matching")},
        {1, 63, 1}),
    row<&P::stereo, &S::texture>("stereo_texture",
                                 {TR("Stereo"), TR("Texture"),
                                  TR("Areas with less mean gradient are not matched: over-exposed, "
                                     "unlit or blank ones give no depth; 0 is off"),
                                  "grey/px"},
                                 {0, 50, 0.1}),
    row<&P::stereo, &S::average>(
        "stereo_average",
        {TR("Stereo"), TR("Average"),
         TR("Frames that a disparity is the mean of: less noise from a still camera, but small "
            "changes are seen 4 frames later; 1 is off"),
         "frames"},
        {1, 200, 5}),
    row<&P::stereo, &S::refine>("stereo_refine",
                                {TR("Stereo"), TR("Refine"),
                                 TR("Turn the right camera by up to a degree, and correct its "
                                    "focal length, so that the rows of both pictures agree")}),
    row<&P::stereo, &S::smooth>(
        "stereo_smooth",
        {TR("Stereo"), TR("Smooth"),
         TR("Width of the neighbourhood that a disparity is the mean of; 0 is off"), "px"},
        {0, 99, 10}),
    row<&P::stereo, &S::maxSlope>(
        "stereo_steepest",
        {TR("Stereo"), TR("Steepest"),
         TR("A disparity that changes by more than this from pixel to pixel is a veil between a "
            "near thing and what is behind it, and goes; 0 is off"),
         "px/px"},
        {0, 100, 0.1}),
    row<&P::validity, &V::maxFrameAge>(
        "max_frame_age",
        {TR("Validity"), TR("Frame age"), TR("Longer without a frame, and there is no distance"),
         "s"},
        {0.05, 60, 0.1}),
    row<&P::validity, &V::identicalFrames>(
        "identical_frames",
        {TR("Validity"), TR("Identical frames"),
         TR("This many equal frames in a row mean a frozen source"), "frames"},
        {2, 1000, 1}),
    row<&P::validity, &V::minFill>(
        "min_fill",
        {TR("Validity"), TR("Smallest fill"), TR("Share of pixels that must have a depth")},
        {0, 1, 0.01}),
    row<&P::validity, &V::sceneMotion>(
        "scene_motion",
        {TR("Validity"), TR("Scene motion"),
         TR("If a larger share of the picture moves, the camera moves; 1 is off")},
        {0.05, 1, 0.05}),
    row<&P::validity, &V::maxLoadAge>(
        "max_load_age",
        {TR("Validity"), TR("Load age"),
         TR("Longer without seeing the load that is detected, and there is no distance"), "s"},
        {0, 60, 0.1}),
    row<&P::validity, &V::minObserved>(
        "min_observed",
        {TR("Validity"), TR("Smallest observed share"),
         TR("Share of the load's neighbourhood that must have been observed")},
        {0.01, 1, 0.05}),
});

}  // namespace boomwatch::table_row
