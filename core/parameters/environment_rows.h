#pragma once

#include "parameters/row_names.h"

/// Rows of bounds, environment model, clearance, watched parts and warning. Only for
/// parameter_table.cpp.
namespace boomwatch::table_row {

inline constexpr auto environmentRows = std::to_array<ParameterInfo>({
    row<&P::bounds, &B::xMin>(
        "x_min",
        {TR("Bounds"), TR("x minimum (left)"), TR("Left limit of the watched space."), "m"},
        coordinate),
    row<&P::bounds, &B::xMax>(
        "x_max",
        {TR("Bounds"), TR("x maximum (right)"), TR("Right limit of the watched space."), "m"},
        coordinate),
    row<&P::bounds, &B::yMin>("y_min",
                              {TR("Bounds"), TR("y minimum (top)"),
                               TR("Upper limit of the watched space; y points down."), "m"},
                              coordinate),
    row<&P::bounds, &B::yMax>("y_max",
                              {TR("Bounds"), TR("y maximum (bottom)"),
                               TR("Lower limit of the watched space; y points down."), "m"},
                              coordinate),
    row<&P::bounds, &B::zMin>(
        "z_min",
        {TR("Bounds"), TR("z minimum (near)"),
         TR("Minimum depth of the watched space. Nearer points are ignored."), "m"},
        coordinate),
    row<&P::bounds, &B::zMax>(
        "z_max",
        {TR("Bounds"), TR("z maximum (far)"),
         TR("Maximum depth of the watched space. Points farther away are ignored."), "m"},
        coordinate),
    row<&P::model, &M::resolution>("resolution",
                                   {TR("Environment model"), TR("Cell size (resolution)"),
                                    TR("Side of a cell of the environment model. A higher value is "
                                       "faster but coarser. Usual: 0.02 to 0.1 m."),
                                    "m"},
                                   {0.001, 1, 0.01}),
    row<&P::model, &M::projection>(
        "model_projection",
        {TR("Environment model"), TR("Projection"),
         TR("parallel: cells are columns along z, as in the thesis. perspective: cells are image "
            "rays, without gaps behind near objects; resolution is then the cell size at half of "
            "z_max.")},
        {}, projectionNames),
    row<&P::model, &M::cellDepth>(
        "cell_depth",
        {TR("Environment model"), TR("Cell depth"),
         TR("surface: mean depth of the surface in the cell. nearest: depth of the nearest point, "
            "up to half a cell too near on slanted surfaces.")},
        {}, cellDepthNames),
    row<&P::model, &M::probtresh>(
        "probtresh",
        {TR("Environment model"), TR("Probability threshold (probtresh)"),
         TR("A cell enters the model when its probability exceeds this. With a higher value "
            "objects enter later and less noise enters. Usual: 0.3 to 0.6.")},
        {0, 1, 0.05}),
    row<&P::model, &M::pPrior>(
        "p_prior",
        {TR("Environment model"), TR("Hit weight (p_prior)"),
         TR("Probability that each hit adds to a cell. With a higher value objects enter the model "
            "sooner. Not used by log_odds. Usual: 0.1 to 0.3.")},
        {0.001, 1, 0.05}),
    row<&P::model, &M::pPost>(
        "p_post",
        {TR("Environment model"), TR("Decay factor (p_post)"),
         TR("Share of its probability that a cell keeps after each frame. With a higher value "
            "objects stay longer. Not used by log_odds. Usual: 0.6 to 0.9.")},
        {0, 0.999, 0.05}),
    row<&P::model, &M::update>(
        "model_update",
        {TR("Environment model"), TR("Update rule"),
         TR("hysteresis: a cell stays until its probability falls to leave_threshold. thesis: a "
            "single miss can remove a cell. log_odds: Bayes' rule.")},
        {}, updateNames),
    row<&P::model, &M::leaveThreshold>(
        "leave_threshold",
        {TR("Environment model"), TR("Leave threshold"),
         TR("hysteresis: a cell leaves the model at this probability. With a higher value objects "
            "leave sooner. It must be below probtresh. Usual: 0.05 to 0.3.")},
        {0.01, 1, 0.05}),
    row<&P::model, &M::logOddsHit>(
        "log_odds_hit",
        {TR("Environment model"), TR("Log-odds hit"),
         TR("log_odds: probability of a cell after one hit. With a higher value objects enter the "
            "model sooner. Usual: 0.6 to 0.8.")},
        {0.51, 0.99, 0.05}),
    row<&P::model, &M::logOddsMiss>("log_odds_miss",
                                    {TR("Environment model"), TR("Log-odds miss"),
                                     TR("log_odds: probability of a cell after one miss. With a "
                                        "higher value objects stay longer. Usual: 0.35 to 0.45.")},
                                    {0.1, 0.49, 0.05}),
    row<&P::model, &M::logOddsLow>(
        "log_odds_low",
        {TR("Environment model"), TR("Log-odds minimum"),
         TR("log_odds: minimum probability from which a hit counts up. With a higher value objects "
            "enter the model sooner. Usual: 0.1 to 0.2.")},
        {0.01, 0.49, 0.05}),
    row<&P::model, &M::logOddsHigh>("log_odds_high",
                                    {TR("Environment model"), TR("Log-odds maximum"),
                                     TR("log_odds: maximum probability that hits lead to. With a "
                                        "higher value objects stay longer. Usual: 0.9 to 0.98.")},
                                    {0.51, 0.999, 0.05}),
    row<&P::model, &M::memoryLimit>(
        "memory_limit",
        {TR("Environment model"), TR("Memory limit"),
         TR("Maximum memory of the environment model. Settings that need more are rejected."),
         "MB"},
        {1, 65536, 64}),
    row<&P::clearance, &C::method>("clearance_method",
                                   {TR("Clearance"), TR("Search method"),
                                    TR("exact: searches every cell. rays: search rays of the "
                                       "thesis, which miss objects between two rays.")},
                                   {}, methodNames),
    row<&P::clearance, &C::interval>("interval",
                                     {TR("Clearance"), TR("Ray spacing (interval)"),
                                      TR("rays: cells between two search rays. A higher value is "
                                         "faster but misses more. Usual: 5 to 10 cells."),
                                      "cells"},
                                     {1, 1000, 1}),
    row<&P::clearance, &C::radius>(
        "radius",
        {TR("Clearance"), TR("Ray length (radius)"),
         TR("rays: length of a search ray. A higher value finds objects farther away and takes "
            "longer. Rays must reach the caution distance. Usual: 50 to 100 cells."),
         "cells"},
        {1, 10000, 10}),
    row<&P::clearance, &C::range>(
        "range",
        {TR("Clearance"), TR("Search range"),
         TR("exact: how far from the load obstacles are searched. It must not be less than the "
            "caution distance. Usual: 5 to 20 m."),
         "m"},
        {0.1, 1000, 1}),
    row<&P::clearance, &C::unknownSpace>(
        "unknown_space",
        {TR("Clearance"), TR("Unobserved space"),
         TR("show: the window shows the unobserved share, and there is no distance where too "
            "little was observed (min_observed). ignore: treats unobserved space as free, as in "
            "the thesis. solid: treats it as an obstacle.")},
        {}, unknownNames),
    row<&P::clearance, &C::smallestThing>(
        "smallest_thing",
        {TR("Clearance"), TR("Minimum object size"),
         TR("Objects smaller than this from corner to corner are drawn but ignored. A higher value "
            "ignores more objects. 0: off. Usual: 0.05 to 0.3 m."),
         "m"},
        {0, 10, 0.05}),
    row<&P::clearance, &C::doubtfulThing>(
        "doubtful_thing",
        {TR("Clearance"), TR("Confirm objects below"),
         TR("Objects smaller than this, from corner to corner or in area, are ignored until nearly "
            "every frame of a while has shown them, unlike a falling leaf. A higher value reports "
            "more objects late. 0: off. Usual: 0.2 to 0.5 m."),
         "m"},
        {0, 10, 0.05}),
    row<&P::watch, &A::load>(
        "watch_load", {TR("Watched parts"), TR("Load"), TR("Measure the distance from the load.")}),
    row<&P::watch, &A::tool>("watch_tool", {TR("Watched parts"), TR("Tool"),
                                            TR("Measure the distance from the tracked tool.")}),
    row<&P::watch, &A::boom>("watch_boom",
                             {TR("Watched parts"), TR("Boom"),
                              TR("Measure the distance from the visible segments of the boom.")}),
    row<&P::warning, &W::cautionDistance>(
        "caution_distance",
        {TR("Warning"), TR("Caution distance"),
         TR("At this distance the caution level begins and the bar begins to fill. A higher value "
            "warns earlier. Usual: 1 to 5 m."),
         "m"},
        {0.01, 100, 0.1}),
    row<&P::warning, &W::warningDistance>("warning_distance",
                                          {TR("Warning"), TR("Warning distance"),
                                           TR("At this distance the warning level begins. A higher "
                                              "value warns earlier. Usual: 0.5 to 2 m."),
                                           "m"},
                                          {0.01, 100, 0.1}),
    row<&P::warning, &W::cautionTime>(
        "caution_time",
        {TR("Warning"), TR("Caution time to contact"),
         TR("Caution also begins when the moving load would touch an obstacle within this time. A "
            "higher value warns earlier. 0: off. Usual: 1 to 4 s."),
         "s"},
        {0, 60, 0.5}),
    row<&P::warning, &W::warningTime>(
        "warning_time",
        {TR("Warning"), TR("Warning time to contact"),
         TR("The warning also begins when the moving load would touch an obstacle within this "
            "time. A higher value warns earlier. 0: off. Usual: 0.5 to 2 s."),
         "s"},
        {0, 60, 0.5}),
    row<&P::warning, &W::deadband>("warning_deadband",
                                   {TR("Warning"), TR("Deadband"),
                                    TR("A level ends this much farther away than it begins. With a "
                                       "higher value levels flicker less. Usual: 0.02 to 0.2 m."),
                                    "m"},
                                   {0, 10, 0.01}),
    row<&P::warning, &W::releaseDelay>(
        "warning_release",
        {TR("Warning"), TR("Release delay"),
         TR("How long a lower level must hold before the window shows it. With a higher value "
            "levels change less often. A load that moves away is released at once. Usual: 0.3 to 1 "
            "s."),
         "s"},
        {0, 60, 0.1}),
});

}  // namespace boomwatch::table_row
