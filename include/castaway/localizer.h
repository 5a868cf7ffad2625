/* The C interface of a localizer in a shared library, version 1.
 *
 * The library exports one function, `castaway_localizer`, which returns a table of functions. All
 * of them are called from one thread, in the order of delivery. No call may throw through the C
 * interface; castaway/plugin.hpp is a C++ class that sees to it.
 *
 * Every struct begins with its own size. A library built for an older header is still understood
 * by a newer castaway, and the other way round: what lies beyond the size is not there.
 *
 * Frames and units: REP-103 and REP-105. Poses are (x, y, yaw) in m and rad; covariances are of
 * (x, y, yaw), row by row; stamps are in ns since an arbitrary beginning.
 */
#ifndef CASTAWAY_LOCALIZER_H
#define CASTAWAY_LOCALIZER_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define CASTAWAY_LOCALIZER_VERSION 1

typedef struct castaway_pose {
  double x, y, yaw;
} castaway_pose;

/* An occupancy grid as ROS has it. */
typedef struct castaway_map {
  size_t size;
  const char* file;     /* The map's YAML file, or NULL. */
  int32_t width;        /* [cells] */
  int32_t height;       /* [cells] */
  double resolution;    /* [m] */
  castaway_pose origin; /* Lower left corner of cell 0 in map. */
  const int8_t* cells;  /* Rows from the smallest y: -1 unknown, 0 free ... 100 occupied. */
} castaway_map;

typedef struct castaway_lidar {
  size_t size;
  const char* name;        /* Empty if there is one lidar. */
  double T_base_laser[12]; /* Mount: the upper three rows of the matrix, row by row. */
  double angle_min;        /* [rad] Of the first beam, about the lidar's z, from its x. */
  double angle_increment;  /* [rad] Signed. */
  double range_min;        /* [m] */
  double range_max;        /* [m] */
  size_t beams;
} castaway_lidar;

/* What a localizer is created with. Pointers are valid during the call only. */
typedef struct castaway_setup {
  size_t size;
  const char* name; /* Of the localizer in the run. */
  uint64_t seed;    /* Root of its random numbers. */
  castaway_map map;
  const castaway_lidar* lidars; /* Those that are known before the run. */
  size_t lidar_count;
  const char* params; /* JSON object. */
} castaway_setup;

typedef struct castaway_start {
  size_t size;
  castaway_pose pose;
  double covariance[9];
} castaway_start;

typedef struct castaway_odometry {
  size_t size;
  int64_t stamp_ns;
  castaway_pose pose; /* Of base in odom. */
  double twist[3];    /* Mean since the reading before, in base: [m/s], [m/s], [rad/s]. */
} castaway_odometry;

typedef struct castaway_scan {
  size_t size;
  int64_t stamp_ns;          /* Of the first beam. */
  int64_t time_increment_ns; /* Between two beams. */
  const castaway_lidar* lidar;
  const float* ranges; /* [m] `lidar->beams` of them. REP-117: +inf no return, -inf too close, NaN
                          invalid. */
} castaway_scan;

typedef struct castaway_hypothesis {
  castaway_pose pose;
  double probability; /* In [0, 1]. */
} castaway_hypothesis;

/* An answer to a scan. castaway fills it with "no pose, nothing stated" before the call. */
typedef struct castaway_estimate {
  size_t size;
  int32_t has_pose;   /* 0: no estimate. */
  int32_t lost;       /* Not 0: the pose must not be used. */
  castaway_pose pose; /* Of base in map, at the scan's stamp. */
  double covariance[9];
  double probability;                    /* In [0, 1] that the pose is right; NaN: not stated. */
  double quality;                        /* In [0, 1]; NaN: not stated. */
  const castaway_hypothesis* hypotheses; /* Valid until the next call; may be NULL. */
  size_t hypothesis_count;
} castaway_estimate;

/* The functions. Those that return an int return 0, or another value after an error. */
typedef struct castaway_localizer_functions {
  size_t size;
  int32_t version; /* CASTAWAY_LOCALIZER_VERSION */
  /* Returns NULL after an error; `error(NULL)` then says what it was. */
  void* (*create)(const castaway_setup* setup);
  void (*destroy)(void* localizer);
  /* `start`: NULL for anywhere on the map. */
  int (*initialize)(void* localizer, const castaway_start* start);
  int (*on_odometry)(void* localizer, const castaway_odometry* odometry);
  int (*on_scan)(void* localizer, const castaway_scan* scan, castaway_estimate* estimate);
  /* What the latest error was, in one line; may be NULL. */
  const char* (*error)(void* localizer);
} castaway_localizer_functions;

#if defined(__GNUC__)
#define CASTAWAY_EXPORT __attribute__((visibility("default")))
#else
#define CASTAWAY_EXPORT
#endif

CASTAWAY_EXPORT const castaway_localizer_functions* castaway_localizer(void);

#ifdef __cplusplus
}
#endif

#endif
