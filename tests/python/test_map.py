"""castaway.Map."""

import math

import numpy as np
import pytest

import castaway


@pytest.fixture
def room():
    """4 m x 2 m inside of walls a cell thick; cells of 0.5 m; the corner at (-1, -1)."""
    cells = np.zeros((6, 10), np.int8)
    cells[[0, -1]] = 100
    cells[:, [0, -1]] = 100
    return castaway.Map(cells, 0.5, origin=(-1.0, -1.0, 0.0), name="room")


def test_rays_end_at_the_walls(room):
    # The free part is x in [-0.5, 3.5], y in [-0.5, 1.5].
    angles = [0.0, math.pi / 2, math.pi, -math.pi / 2]
    assert np.allclose(room.cast((1.0, 0.5, 0.0), angles), [2.5, 1.0, 1.5, 1.0])
    assert np.allclose(room.cast((1.0, 0.5, math.pi / 2), [0.0]), [1.0])


def test_a_ray_without_a_wall_is_infinite(room):
    assert np.isinf(room.cast((1.0, 0.5, 0.0), [0.0], range_max=2.0)).all()


def test_many_poses_are_cast_at_once(room):
    poses = np.array([(1.0, 0.5, 0.0), (2.0, 0.5, 0.0)])
    ranges = room.cast(poses, np.array([0.0, 0.1]))
    assert ranges.shape == (2, 2)
    assert ranges.dtype == np.float32
    assert np.array_equal(ranges[1], room.cast(poses[1], [0.0, 0.1]))
    assert room.cast(poses).shape == (2, 360)


def test_the_distance_field_is_exact_between_centres(room):
    field = room.distance_field
    assert field.shape == (6, 10)
    walls = np.argwhere(room.cells == 100)
    for cell in np.ndindex(field.shape):
        nearest = np.hypot(*(walls - cell).T).min() * room.resolution
        assert field[cell] == pytest.approx(nearest)
    assert room.distance_field.ctypes.data == field.ctypes.data  # A view, computed once.


def test_a_map_survives_its_file(room, tmp_path):
    room.save(tmp_path / "room.yaml")
    loaded = castaway.Map.load(tmp_path / "room.yaml")
    assert np.array_equal(loaded.cells, room.cells)
    assert (loaded.name, loaded.origin, loaded.resolution) == ("room", (-1.0, -1.0, 0.0), 0.5)


def test_arrays_outlive_the_map_and_are_read_only(room):
    cells = room.cells
    with pytest.raises(ValueError, match="read-only"):
        cells[0, 0] = 1
    del room
    assert cells.sum() == 2 * 10 * 100 + 2 * 4 * 100


def test_wrong_arguments_are_value_errors(room):
    with pytest.raises(ValueError, match="n x 3"):
        room.cast([1.0, 2.0])
    with pytest.raises(ValueError, match="range_max"):
        room.cast((0.0, 0.0, 0.0), range_max=-1.0)
    with pytest.raises(ValueError, match="height x width"):
        castaway.Map([1, 2], 0.1)
    with pytest.raises(ValueError):
        castaway.Map(np.zeros((2, 2)), 0.0)
    with pytest.raises(castaway.Error, match="nowhere.yaml"):
        castaway.Map.load("nowhere.yaml")


def test_cells_that_would_be_cut_are_refused():
    for cells in (np.full((2, 2), 0.7), np.full((2, 2), 300), np.full((2, 2), 255, np.uint8)):
        with pytest.raises(ValueError, match="whole numbers from -1 to 100"):
            castaway.Map(cells, 0.5)
    assert castaway.Map(np.full((2, 2), 100.0), 0.5).cells[0, 0] == 100
    assert castaway.Map([[0, -1], [100, 50]], 0.5).cells.tolist() == [[0, -1], [100, 50]]
