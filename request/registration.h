// Changes of a map by the words crop, despike, mirror, shift and resample, and others that surface.cpp needs.
#pragma once

#include "request/request.h"

namespace rc::request {

bool same_pitch(double a, double b, double tolerance = 1e-6);
// Throws what a function of libroughcontact-formats refuses, of this map.
void check_formats(rc_status status, const Map& map);
// NaN where the mask leaves a point out, so that steps of the preparation need no mask.
void mark_masked(Map& map);

void crop(const Words& words, Units& units, Map& map, rc_request& request);
// Marks spikes as missing; returns their number.
std::int64_t despike(const Words& words, Map& map, rc_request& request);
// Of the other body.
void mirror(const Words& words, Map& other);
// Shifts the other body and brings it onto the grid of the map; both lose points without a partner, unless the other repeats.
void onto_grid(const Words& words, Units& units, Map& other, Map& map, rc_request& request);

}  // namespace rc::request
