#pragma once

#include "parameters/row_names.h"

/// The rows of what is watched, modelled, searched and warned of; only for parameter_table.cpp.
namespace boomwatch::table_row {

inline constexpr auto modelRows = std::to_array<ParameterInfo>({
    row<&P::bounds, &B::xMin>(
        "x_min", {TR("Bounds"), TR("x from"), TR("Left limit of the watched space"), "m"},
        coordinate),
    row<&P::bounds, &B::xMax>(
        "x_max", {TR("Bounds"), TR("x to"), TR("Right limit of the watched space"), "m"},
        coordinate),
    row<&P::bounds, &B::yMin>(
        "y_min",
        {TR("Bounds"), TR("y from"), TR("Upper limit of the watched space (y points down)"), "m"},
        coordinate),
    row<&P::bounds, &B::yMax>(
        "y_max",
        {TR("Bounds"), TR("y to"), TR("Lower limit of the watched space (y points down)"), "m"},
        coordinate),
    row<&P::bounds, &B::zMin>(
        "z_min", {TR("Bounds"), TR("z from"), TR("Nearest distance that is watched"), "m"},
        coordinate),
    row<&P::bounds, &B::zMax>(
        "z_max", {TR("Bounds"), TR("z to"), TR("Farthest distance that is watched"), "m"},
        coordinate),
    row<&P::model, &M::resolution>(
        "resolution",
        {TR("Model"), TR("Resolution"), TR("Side of a cell of the environment model (R)"), "m"},
        {0.001, 1, 0.01}),
    row<&P::model, &M::projection>(
        "model_projection",
        {TR("Model"), TR("Projection"),
         TR("parallel: columns along z (the thesis's); perspective: image rays, no gap behind near "
            "things; there a cell is resolution wide at half of z_max")},
        {}, projectionNames),
    row<&P::model, &M::cellDepth>(
        "cell_depth",
        {TR("Model"), TR("Cell depth"),
         TR("nearest: that of the nearest point in a cell (Eq. 10), up to half a cell too near "
            "where a surface is seen at an angle; surface: the mean of the surface there")},
        {}, cellDepthNames),
    row<&P::model, &M::probtresh>("probtresh",
                                  {TR("Model"), TR("probtresh"),
                                   TR("A cell must be more probable than this to count (P_limit)")},
                                  {0, 1, 0.05}),
    row<&P::model, &M::pPrior>(
        "p_prior", {TR("Model"), TR("p prior"), TR("Probability that a hit adds (Eq. 8)")},
        {0.001, 1, 0.05}),
    row<&P::model, &M::pPost>(
        "p_post",
        {TR("Model"), TR("p post"), TR("Share of the probability left after each frame (Eq. 8)")},
        {0, 0.999, 0.05}),
    row<&P::model, &M::update>("model_update",
                               {TR("Model"), TR("Update"),
                                TR("thesis: Eq. 8-9, one miss can drop a cell; hysteresis: a cell "
                                   "leaves only at the leave threshold; log_odds: Bayes' rule")},
                               {}, updateNames),
    row<&P::model, &M::leaveThreshold>(
        "leave_threshold",
        {TR("Model"), TR("Leave threshold"),
         TR("hysteresis: at this probability a cell no longer counts; below probtresh")},
        {0.01, 1, 0.05}),
    row<&P::model, &M::logOddsHit>(
        "log_odds_hit",
        {TR("Model"), TR("Odds hit"), TR("log_odds: probability of a cell that is measured once")},
        {0.51, 0.99, 0.05}),
    row<&P::model, &M::logOddsMiss>(
        "log_odds_miss",
        {TR("Model"), TR("Odds miss"), TR("log_odds: probability of a cell that is missed once")},
        {0.1, 0.49, 0.05}),
    row<&P::model, &M::logOddsLow>(
        "log_odds_low",
        {TR("Model"), TR("Odds low"), TR("log_odds: a hit starts from this probability at least")},
        {0.01, 0.49, 0.05}),
    row<&P::model, &M::logOddsHigh>(
        "log_odds_high",
        {TR("Model"), TR("Odds high"), TR("log_odds: hits raise the probability to this at most")},
        {0.51, 0.999, 0.05}),
    row<&P::model, &M::memoryLimit>(
        "memory_limit",
        {TR("Model"), TR("Memory limit"), TR("Memory that the model may take"), "MB"},
        {1, 65536, 64}),
    row<&P::clearance, &C::method>("clearance_method",
                                   {TR("Clearance"), TR("Method"),
                                    TR("exact: every cell; rays: the thesis's search rays, which "
                                       "miss what lies between them")},
                                   {}, methodNames),
    row<&P::clearance, &C::interval>(
        "interval",
        {TR("Clearance"), TR("Interval"), TR("rays: cells between two search rays (I)"), "cells"},
        {1, 1000, 1}),
    row<&P::clearance, &C::radius>(
        "radius", {TR("Clearance"), TR("Radius"), TR("rays: length of a search ray (L)"), "cells"},
        {1, 10000, 10}),
    row<&P::clearance, &C::range>(
        "range",
        {TR("Clearance"), TR("Range"), TR("exact: beyond this there is nothing in range"), "m"},
        {0.1, 1000, 1}),
    row<&P::clearance, &C::unknownSpace>(
        "unknown_space",
        {TR("Clearance"), TR("Unknown space"),
         TR("ignore: as if it were free (the thesis's); show: said and drawn, and too little seen "
            "is "
            "no distance; solid: what was never seen counts as an obstacle")},
        {}, unknownNames),
    row<&P::clearance, &C::smallestThing>(
        "smallest_thing",
        {TR("Clearance"), TR("Smallest thing"),
         TR("What is smaller from corner to corner is drawn but does not count; 0 counts all"),
         "m"},
        {0, 10, 0.05}),
    row<&P::clearance, &C::doubtfulThing>(
        "doubtful_thing",
        {TR("Clearance"), TR("Doubtful thing"),
         TR("What is smaller, from corner to corner or in area, counts only once it was seen in "
            "nearly every frame for a while (falling leaves are not); 0: all counts at once"),
         "m"},
        {0, 10, 0.05}),
    row<&P::watch, &A::load>("watch_load",
                             {TR("Watched"), TR("Load"), TR("Watch the distance from the load")}),
    row<&P::watch, &A::tool>("watch_tool", {TR("Watched"), TR("Tool"),
                                            TR("Watch the distance from the tool that is "
                                               "followed")}),
    row<&P::watch, &A::boom>("watch_boom", {TR("Watched"), TR("Boom"),
                                            TR("Watch the distance from the boom's segments, as "
                                               "far as they are seen")}),
    row<&P::warning, &W::cautionDistance>(
        "caution_distance", {TR("Warning"), TR("Caution below"), TR("The bar begins here"), "m"},
        {0.01, 100, 0.1}),
    row<&P::warning, &W::warningDistance>(
        "warning_distance",
        {TR("Warning"), TR("Warning below"), TR("The warning begins here"), "m"}, {0.01, 100, 0.1}),
    row<&P::warning, &W::cautionTime>(
        "caution_time",
        {TR("Warning"), TR("Caution time"),
         TR("Caution also begins when the load, as it moves, would touch something within this "
            "time; 0 is off"),
         "s"},
        {0, 60, 0.5}),
    row<&P::warning, &W::warningTime>(
        "warning_time",
        {TR("Warning"), TR("Warning time"),
         TR("The warning also begins when the load, as it moves, would touch something within "
            "this time; 0 is off"),
         "s"},
        {0, 60, 0.5}),
    row<&P::warning, &W::deadband>("warning_deadband",
                                   {TR("Warning"), TR("Deadband"),
                                    TR("A level ends this much farther away than it begins"), "m"},
                                   {0, 10, 0.01}),
    row<&P::warning, &W::releaseDelay>(
        "warning_release",
        {TR("Warning"), TR("Release delay"),
         TR("A level ends only after a lower one would have done for so long; a load that retreats "
            "is not kept waiting"),
         "s"},
        {0, 60, 0.1}),
});

}  // namespace boomwatch::table_row
