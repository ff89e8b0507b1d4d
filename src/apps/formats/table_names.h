// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

namespace annulus::inline v1 {

// The names that programs and data sets give to the columns of tables, in lower case, without blanks, underscores,
// hyphens and units. Of several that a header has, the first is preferred.

/// The frame: PeTrack and trackpy call it frame, JuPedSim FR, CellProfiler ImageNumber, Manual Tracking Slice n° (in
/// UTF-8 or Latin-1); napari and Pathfinder t, crowd:it time, SUMO timestep_time, Viswalk SIMSEC.
inline constexpr auto frame_names = std::to_array<std::string_view>(
    {"frame",      "fr",       "framenumber",  "frameno",   "framenum",    "framenr",        "frameid",
     "frameindex", "frameidx", "imagenumber",  "slice",     "slicenumber", "slicen\xc2\xb0", "slicen\xb0",
     "t",          "time",     "timestep",     "timepoint", "timeframe",   "timeindex",      "positiont",
     "simtime",    "simsec",   "timesteptime", "timestamp"});

/// The id: TrackMate and napari have TRACK_ID, Imaris TrackID, MTrackJ TID, trackpy particle, MosaicSuite Trajectory,
/// Manual Tracking Track n°, NGSIM Vehicle_ID, Viswalk $PEDESTRIAN:NO.
inline constexpr auto id_names = std::to_array<std::string_view>(
    {"trackid",    "trackingid", "track",         "tracknumber", "trackno",  "trackn\xc2\xb0",
     "trackn\xb0", "trajectory", "trajectoryid",  "tid",         "particle", "particleid",
     "id",         "pedid",      "pedestrianid",  "personid",    "agentid",  "objectid",
     "cellid",     "vehicleid",  "$pedestrian:no"});

/// x, y and z of one kind: TrackMate has POSITION_X, Imaris Position X, crowd:it posX, ilastik Object_Center_0, inD
/// xCenter, NGSIM Local_X, SUMO vehicle_x, Viswalk COORDCENTX.
inline constexpr std::array<std::array<std::string_view, 3>, 13> coordinate_names{
    {{"x", "y", "z"},
     {"positionx", "positiony", "positionz"},
     {"posx", "posy", "posz"},
     {"xpos", "ypos", "zpos"},
     {"xcoord", "ycoord", "zcoord"},
     {"centroidx", "centroidy", "centroidz"},
     {"centerx", "centery", "centerz"},
     {"xcenter", "ycenter", "zcenter"},
     {"locationcenterx", "locationcentery", "locationcenterz"},
     {"objectcenter0", "objectcenter1", "objectcenter2"},
     {"localx", "localy", "localz"},
     {"vehiclex", "vehicley", "vehiclez"},
     {"coordcentx", "coordcenty", "coordcentz"}}};

}  // namespace annulus::inline v1
