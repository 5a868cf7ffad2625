/* Dead reckoning as a localizer for castaway, in C: the start pose and odometry, no scans.
 *
 *   cc -O2 -shared -fPIC -I../../plugin dead_reckoning.c -o libdead_reckoning.so -lm
 *   castaway run --localizer mh_amcl --localizer library:./libdead_reckoning.so
 */
#include <castaway/localizer.h>
#include <math.h>
#include <stdlib.h>

typedef struct {
  int known;               /* There is a start, */
  int placed;              /* and odometry since. */
  castaway_pose start;     /* T_map_base */
  castaway_pose map_odom;  /* T_map_odom */
  castaway_pose odom_base; /* T_odom_base */
} dead_reckoning;

static castaway_pose compose(castaway_pose a, castaway_pose b) {
  castaway_pose c = {a.x + cos(a.yaw) * b.x - sin(a.yaw) * b.y,
                     a.y + sin(a.yaw) * b.x + cos(a.yaw) * b.y, a.yaw + b.yaw};
  return c;
}

static castaway_pose invert(castaway_pose a) {
  castaway_pose b = {-cos(a.yaw) * a.x - sin(a.yaw) * a.y, sin(a.yaw) * a.x - cos(a.yaw) * a.y,
                     -a.yaw};
  return b;
}

static void* create(const castaway_setup* setup) {
  (void)setup;
  return calloc(1, sizeof(dead_reckoning));
}

static int initialize(void* self, const castaway_start* start) {
  dead_reckoning* it = self;
  it->known = start != NULL;
  it->placed = 0;
  if (start != NULL) it->start = start->pose;
  return 0;
}

static int on_odometry(void* self, const castaway_odometry* odometry) {
  dead_reckoning* it = self;
  it->odom_base = odometry->pose;
  if (it->known && !it->placed) {
    it->map_odom = compose(it->start, invert(odometry->pose));
    it->placed = 1;
  }
  return 0;
}

static int on_scan(void* self, const castaway_scan* scan, castaway_estimate* estimate) {
  dead_reckoning* it = self;
  (void)scan;
  estimate->has_pose = it->placed;
  if (it->placed) estimate->pose = compose(it->map_odom, it->odom_base);
  return 0;
}

static const char* error(void* self) { return self == NULL ? "out of memory" : NULL; }

const castaway_localizer_functions* castaway_localizer(void) {
  static const castaway_localizer_functions functions = {sizeof(castaway_localizer_functions),
                                                         CASTAWAY_LOCALIZER_VERSION,
                                                         create,
                                                         free,
                                                         initialize,
                                                         on_odometry,
                                                         on_scan,
                                                         error};
  return &functions;
}
