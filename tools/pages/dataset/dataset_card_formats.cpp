#include "tools/pages/dataset/dataset_card_formats.hpp"

#include <algorithm>

namespace castaway::testbed {
namespace {

/// A file format: how its paths end within a sequence, its table row, and code that loads it.
struct Format {
  const char* ending;
  const char* row;
  const char* code;
};

constexpr Format kFormats[] = {
    {"/sequence.json", "`sequence.json` | what the sequence holds, how hard it is, its files", ""},
    {"/scenario.yaml", "`scenario.yaml` | what reproduces the run",
     "The run again, with pictures and a report:\n\n```\n"
     "castaway run sequences/000000/scenario.yaml --out again --set outputs.report=true "
     "--set outputs.snapshots.every_s=10 --set 'localizers=[mh_amcl]'\n```\n"},
    {"/tables.h5", "`tables.h5` | scans with labels, odometry, people, events (HDF5)",
     "```python\n"
     "import h5py\n"
     "with h5py.File('sequences/000000/tables.h5') as f:\n"
     "    lidar = next(iter(f['lidars'].values()))\n"
     "    ranges = lidar['ranges'][:]        # scans x beams, m; inf: no return\n"
     "    classes = lidar['classes'][:]      # what each beam met, an index into f['classes']\n"
     "    people = classes == list(f['classes'].asstr()).index('person')\n"
     "    pose = lidar['pose'][:]            # true x, y, yaw of base in map\n"
     "    print(ranges.shape, people.mean(), lidar['ranges'].attrs['unit'])\n```\n"},
    {"/tables/scans.csv", "`tables/*.csv` | the same as text",
     "```python\n"
     "import numpy as np, pandas as pd\n"
     "scans = pd.read_csv('sequences/000000/tables/scans.csv')\n"
     "ranges = np.stack(scans.ranges_m.map(lambda row: np.array(row.split(), float)))\n"
     "classes = np.stack(scans.classes.map(lambda row: np.array(row.split(), int)))\n```\n"},
    {".mcap", "`bag/` | ROS 2 bag (MCAP)",
     "```\nros2 bag play sequences/000000/bag      # or open the .mcap file in Foxglove\n```\n"},
    {"/truth.tum", "`truth.tum`, `<localizer>.tum` | trajectories (TUM)",
     "```\nevo_traj tum sequences/000000/truth.tum --plot\n```\n"},
    {"/log.carmen", "`log.carmen` | CARMEN log", ""},
    {"/kitti/poses.txt", "`kitti/poses.txt`, `kitti/times.txt` | true poses (KITTI odometry)", ""},
    {"/camera/camera.json",
     "`camera/` | colour, depth (mm) and instances from a camera on the robot, people as COCO has "
     "them",
     "```python\n"
     "from PIL import Image\n"
     "import json, numpy as np\n"
     "camera = 'sequences/000000/camera/'\n"
     "depth_m = np.asarray(Image.open(camera + 'depth/000000.png')) / 1000.0   # along the axis\n"
     "people = np.asarray(Image.open(camera + 'instances/000000.png')) >= 60000\n"
     "boxes = [a['bbox'] for a in json.load(open(camera + 'coco.json'))['annotations']]\n```\n"},
    {"/map/map.yaml", "`map/map.yaml`, `map/map.pgm` | the map (ROS)", ""},
    {"/errors.csv", "`errors.csv` | the localizers' errors, where any ride along", ""},
    {"/events.csv", "`events.csv` | kidnaps, faults, collisions, alarms, recoveries", ""},
    {"/people.csv", "`people.csv` | where people were", ""},
    {"/summary.json", "`summary.json` | what the run amounts to", ""}};

bool has(const DatasetContents& contents, const std::string& ending) {
  return std::any_of(contents.files.begin(), contents.files.end(),
                     [&](const ManifestFile& file) { return file.path.ends_with(ending); });
}

}  // namespace

std::string describe_formats(const DatasetContents& contents) {
  std::string rows;
  std::string code;
  for (const Format& format : kFormats) {
    if (!has(contents, format.ending)) continue;
    rows += std::string("| ") + format.row + " |\n";
    if (*format.code != '\0') code += std::string("\n") + format.code;
  }
  return "\n## Files\n\nIn every folder of `sequences/`:\n\n| | |\n|---|---|\n" + rows +
         "\nBeside them `sequences.csv` (a row for each), `splits/`, `maps/<world>.yaml` (ROS "
         "maps),\n`manifest.json` and `SHA256SUMS`. Lengths are in metres, angles in radians, "
         "times "
         "in seconds; x points forward, y left\n(REP-103); `map -> odom -> base` (REP-105).\n" +
         code;
}

}  // namespace castaway::testbed
