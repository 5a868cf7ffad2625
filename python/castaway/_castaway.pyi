"""castaway's C++. Use what `castaway` exports."""

import os
from typing import Any, Iterable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

__version__: str

_Pose = tuple[float, float, float]

class Error(RuntimeError):
    """A run, a file or a setting that castaway cannot work with; says why."""

class Lidar:
    """What the scans of a lidar have in common."""

    @property
    def name(self) -> str: ...
    @property
    def T_base_laser(self) -> NDArray[np.float64]: ...
    @property
    def angle_min(self) -> float: ...
    @property
    def angle_increment(self) -> float: ...
    @property
    def range_min(self) -> float: ...
    @property
    def range_max(self) -> float: ...
    @property
    def beams(self) -> int: ...

class Scan:
    """One sweep of a planar lidar with any mount."""

    def __init__(
        self,
        ranges: ArrayLike,
        *,
        stamp_ns: int,
        angle_min: float,
        angle_increment: float,
        range_min: float,
        range_max: float,
        time_increment_s: float = 0.0,
        T_base_laser: ArrayLike | None = None,
        lidar: str = "",
    ) -> None: ...
    def __len__(self) -> int: ...
    @property
    def stamp_ns(self) -> int:
        """[ns] Time of the first beam."""
    @property
    def time_increment_s(self) -> float:
        """[s] Between two beams; 0 if all were taken at once."""
    @property
    def angle_min(self) -> float:
        """[rad] About the lidar's z, from its x."""
    @property
    def angle_increment(self) -> float:
        """[rad] Signed."""
    @property
    def range_min(self) -> float:
        """[m] Shorter returns are invalid."""
    @property
    def range_max(self) -> float:
        """[m] Longer returns are invalid."""
    @property
    def ranges(self) -> NDArray[np.float32]:
        """[m] A view: inf no return, -inf too close, nan invalid."""
    @property
    def angles(self) -> NDArray[np.float64]:
        """[rad] Of the beams."""
    @property
    def T_base_laser(self) -> NDArray[np.float64]:
        """The lidar's mount, 4 x 4."""
    @property
    def lidar(self) -> str:
        """Name of the lidar if there are several."""

class Map:
    """An occupancy grid, as ROS' map_server has it."""

    def __init__(
        self, cells: ArrayLike, resolution: float, origin: ArrayLike = ..., name: str = "map"
    ) -> None:
        """cells: height x width, rows from the smallest y: -1 unknown, 0 free ... 100 occupied."""
    @staticmethod
    def load(file: str | os.PathLike[str]) -> Map:
        """Reads a map's YAML file and its image. Raises Error."""
    def save(self, file: str | os.PathLike[str]) -> None:
        """Writes the YAML file and <stem>.pgm beside it."""
    def cast(
        self, pose: ArrayLike, angles: ArrayLike | None = None, range_max: float = 12.0
    ) -> NDArray[np.float32]:
        """Ranges [m] that an ideal lidar measures at a pose in map, a range for each angle; for n
        poses (n x 3), n x angles. angles: [rad] from the pose's x; None: 360 over a turn. Unknown
        cells and the outside of the map end a beam; inf: nothing within `range_max`."""
    @property
    def cells(self) -> NDArray[np.int8]:
        """Height x width, a view: -1 unknown, 0 free ... 100 occupied."""
    @property
    def distance_field(self) -> NDArray[np.float32]:
        """[m] Height x width, a view: from each cell to the nearest wall."""
    @property
    def name(self) -> str: ...
    @property
    def width(self) -> int:
        """[cells]"""
    @property
    def height(self) -> int:
        """[cells]"""
    @property
    def resolution(self) -> float:
        """[m] Edge of a cell."""
    @property
    def origin(self) -> _Pose:
        """Pose of the lower left corner of cell (0, 0) in map."""

class Estimate:
    """A localizer's answer to a scan, at its stamp."""

    def __init__(
        self,
        pose: ArrayLike,
        *,
        covariance: ArrayLike | None = None,
        probability: float = ...,
        quality: float = ...,
        lost: bool = False,
        hypotheses: Iterable[tuple[ArrayLike, float]] = (),
    ) -> None:
        """Raises ValueError for values that are not finite or out of range."""
    @property
    def pose(self) -> _Pose:
        """Of base in map."""
    @property
    def covariance(self) -> NDArray[np.float64]:
        """Of (x, y, yaw), 3 x 3."""
    @property
    def probability(self) -> float:
        """In [0, 1] that the pose is right; nan: not stated."""
    @property
    def quality(self) -> float:
        """In [0, 1], how well the scan fits the map; nan: not stated."""
    @property
    def lost(self) -> bool:
        """The alarm: the pose must not be used."""
    @property
    def hypotheses(self) -> list[tuple[_Pose, float]]:
        """Poses and their probabilities."""

class Population:
    """One population of particles."""

    @property
    def id(self) -> int: ...
    @property
    def pose(self) -> _Pose: ...
    @property
    def quality(self) -> float: ...
    @property
    def probability(self) -> float: ...
    @property
    def selected(self) -> bool: ...
    @property
    def particles(self) -> NDArray[np.float64]:
        """Poses of base in map, n x 3."""

class Setup:
    """What a localizer is told once, before the run."""

    @property
    def name(self) -> str: ...
    @property
    def seed(self) -> int: ...
    @property
    def map(self) -> Map: ...
    @property
    def lidars(self) -> list[Lidar]: ...

class OdometryFrame:
    """A reading of wheel odometry, with its truth."""

    @property
    def stamp_ns(self) -> int: ...
    @property
    def pose(self) -> _Pose:
        """Of base in odom."""
    @property
    def truth(self) -> _Pose | None:
        """True pose of base in map."""

class ImuFrame:
    """A reading of an inertial measurement unit, in base."""

    @property
    def stamp_ns(self) -> int: ...
    @property
    def angular_velocity(self) -> tuple[float, float, float]:
        """(x, y, z) [rad/s]"""
    @property
    def linear_acceleration(self) -> tuple[float, float, float]:
        """(x, y, z) [m/s^2] Specific force: at rest on level ground (0, 0, 9.81)."""

class ScanFrame:
    """A scan, delivered at the time of its last beam, with its truth."""

    @property
    def stamp_ns(self) -> int:
        """[ns] Time of delivery; the scan's own is that of its first beam."""
    @property
    def scan(self) -> Scan: ...
    @property
    def truth(self) -> _Pose | None:
        """True pose of base in map at the scan's stamp."""
    @property
    def people(self) -> NDArray[Any]:
        """Structured: id, x_m, y_m, yaw_rad, vx_m_per_s, vy_m_per_s, gap_m."""
    @property
    def beams_on_people(self) -> float:
        """Share of the beams that hit people."""
    @property
    def labels(self) -> NDArray[np.int32]:
        """By beam: what it hit (`Simulation.label_name`)."""
    @property
    def intensities(self) -> NDArray[np.float32]:
        """By beam; empty if the lidar reports none."""

class Event:
    """Something that happened to the robot."""

    @property
    def stamp_ns(self) -> int: ...
    @property
    def kind(self) -> str:
        """"kidnap", "pick-up", "collision", "fault on", ..."""
    @property
    def detail(self) -> str: ...
    @property
    def pose_from(self) -> _Pose | None:
        """True pose of base in map before."""
    @property
    def pose_to(self) -> _Pose | None:
        """True pose of base in map after."""

class NativeLocalizer:
    def __init__(self, yaml: str, map: Map, seed: int, who: str) -> None: ...
    def initialize(self, pose: ArrayLike | None, covariance: ArrayLike | None) -> None: ...
    def on_odometry(self, stamp_ns: int, pose: ArrayLike) -> None: ...
    def on_scan(self, scan: Scan) -> Estimate | None: ...
    @property
    def populations(self) -> list[Population]: ...

class ScenarioRequest:
    def __init__(self, scenario: str, overrides: Sequence[str], allow_programs: bool) -> None: ...

class Played:
    @property
    def failed(self) -> dict[str, str]: ...
    @property
    def missed(self) -> list[str]: ...
    @property
    def warnings(self) -> list[str]: ...

class NativeSimulation:
    def __init__(self, request: ScenarioRequest) -> None: ...
    def __iter__(self) -> NativeSimulation: ...
    def __next__(self) -> OdometryFrame | ScanFrame | Event: ...
    def command(self, v: float, w: float) -> None: ...
    def follow_route(self) -> None: ...
    def kidnap(self, pose: ArrayLike) -> None: ...
    def set_estimate(self, pose: ArrayLike | None) -> None: ...
    def label_name(self, label: int) -> str: ...
    @property
    def start_pose(self) -> _Pose: ...
    @property
    def duration_s(self) -> float: ...
    @property
    def map(self) -> Map: ...
    @property
    def lidars(self) -> list[Lidar]: ...
    @property
    def scenario(self) -> str: ...
    @property
    def warnings(self) -> list[str]: ...

class EvaluationConfig:
    starts: int
    kidnaps: int
    window_s: float
    tracking: bool
    seed: int
    kidnap_to: str
    def __init__(self) -> None: ...

class LocalizerSpec:
    def __init__(self, name: str, localizer: Any = ...) -> None: ...
    @property
    def name(self) -> str: ...

class RecordedPlace:
    def __init__(self, folder: str, localizers: list[LocalizerSpec], map3d: str) -> None: ...

def set_shipped_data(folder: str) -> None: ...
def use_renderer_in(folder: str) -> None: ...
def data_root() -> str: ...
def scenarios() -> list[str]:
    """The scenarios that come along, as `castaway.run` takes them."""

def localizer_yaml(text: str) -> str: ...
def file_name_of(text: str) -> str: ...
def localizer_seed(run_seed: int, name: str) -> int: ...
def play(
    request: ScenarioRequest, localizers: dict[str, Any], out: str, force: bool
) -> Played: ...
def write_report(folder: str) -> None: ...
def evaluate(place: RecordedPlace, localizer: LocalizerSpec, config: EvaluationConfig) -> str: ...
