"""Tests of the package asos. Run by ctest with PYTHONPATH at the built package."""

import os
import pathlib
import signal
import sys
import tempfile
import threading
import types
import unittest
import unittest.mock

import numpy as np

import asos

SMALL = {"width": 64, "height": 36}


def triangle(**options):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float64)
    return asos.Mesh(corners, np.array([[0, 1, 2]]), **options)


class Pictures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = asos.load("builtin:boxes")
        cls.picture = cls.scene.render(**SMALL)

    def test_layers_are_arrays_of_the_size(self):
        beauty = self.picture["beauty"]
        self.assertEqual(beauty.shape, (36, 64, 3))
        self.assertEqual(beauty.dtype, np.float32)
        self.assertGreater(beauty.mean(), 0.05)
        self.assertEqual(self.picture["level"].shape, (36, 64))
        self.assertIn("cause", self.picture.layers)
        with self.assertRaises(asos.InvalidArgument) as raised:
            self.picture["no such layer"]
        self.assertIn("no such layer", raised.exception.subject)

    def test_arrays_outlive_their_picture(self):
        beauty = self.scene.render(**SMALL)["beauty"]
        np.testing.assert_array_equal(beauty, self.picture["beauty"])

    def test_split_map_names_its_causes(self):
        split = self.picture.split_map()
        self.assertEqual(split.level.dtype, np.uint8)
        self.assertEqual(split.names[0], "none")
        self.assertLess(split.cause.max(), len(split.names))
        self.assertGreater((split.cause == split.names.index("outline")).sum(), 50)

    def test_compare_measures_display_range(self):
        self.assertEqual(asos.compare(self.picture, self.picture)[:2], (0.0, float("inf")))
        sampled = self.scene.render(**SMALL, method="sobol", samples=64)
        difference = asos.compare(self.picture, sampled)
        self.assertGreater(difference.rmse, 0)
        self.assertLess(difference.rmse, 0.02)
        self.assertAlmostEqual(difference.psnr, -20 * np.log10(difference.rmse))
        with self.assertRaises(ValueError):
            asos.compare(self.picture, self.scene.render(width=32, height=36))

    def test_arrays_are_the_pictures_own_memory(self):
        first, second = self.picture["beauty"], self.picture["beauty"]
        self.assertTrue(np.shares_memory(first, second))
        self.assertFalse(first.flags.writeable)
        with self.assertRaises(ValueError):
            first[0, 0] = 1
        self.assertFalse(np.shares_memory(self.picture["level"], self.picture["level"]))

    def test_layers_that_are_asked_for(self):
        names = [layer.name for layer in asos.layers()]
        picture = self.scene.render(**SMALL, layers=["depth", "object"])
        self.assertEqual(set(picture.layers) - set(self.picture.layers), {"depth", "object"})
        self.assertLess(set(picture.layers), set(names))
        np.testing.assert_array_equal(picture["beauty"], self.picture["beauty"])
        self.assertTrue((picture["depth"] > 0).all())
        shares = picture.id_shares("object")
        area = np.zeros(64 * 36)
        np.add.at(area, shares.pixel, shares.share)
        np.testing.assert_allclose(area, 1, atol=1e-5)
        largest = picture["object"].astype(int)
        self.assertIn(largest[18, 32], range(len(shares.names)))

    def test_the_split_map_can_be_predicted(self):
        level = self.picture.split_map().level
        same = self.picture.predicted_level(1 / 256, 4)
        self.assertEqual(same.dtype, np.uint8)
        self.assertGreater((same == level).mean(), 0.9)
        self.assertEqual(self.picture.predicted_level(1, 0).max(), 0)
        with self.assertRaises(asos.InvalidArgument):
            self.picture.predicted_level(2, 4)

    def test_other_settings_by_their_names(self):
        names = {setting.name for setting in asos.settings()}
        self.assertIn("filter_width", names)
        wide = self.scene.render(**SMALL, filter_width=2, refine_shading=False)
        self.assertGreater(asos.compare(wide, self.picture).rmse, 0.005)
        with self.assertRaises(TypeError):
            self.scene.render(**SMALL, no_such_setting=1)
        with self.assertRaises(asos.InvalidArgument) as raised:
            self.scene.render(**SMALL, filter_width=5)
        self.assertEqual(raised.exception.subject, "filter_width")
        mirrors = self.scene.render(**SMALL, dfr=(0.5, 0.5, 1))
        self.assertTrue(mirrors.finished)

    def test_cameras_are_fitted_and_have_a_lens(self):
        camera = asos.look_at((0, 1, 4), (0, 0, 0), fov_y_rad=0.8)
        camera.aspect_ratio = 2
        self.assertEqual(asos.fitted(camera, 2).fov_y_rad, 0.8)
        self.assertGreater(asos.fitted(camera, 1).fov_y_rad, 0.8)
        self.assertEqual(asos.fitted(camera, 1, "crop").fov_y_rad, 0.8)
        camera.aperture_radius = asos.aperture_of_f_stop(0.2, 0.8)
        camera.blades = 5
        blurred = self.scene.render(camera, **SMALL, method="sobol")
        camera.aperture_radius = 0
        sharp = self.scene.render(camera, **SMALL, method="sobol")
        self.assertGreater(asos.compare(blurred, sharp).rmse, 0.003)

    def test_a_bar_needs_no_tqdm(self):
        shown = []

        class Bar:
            n = 0

            def __init__(self, **_options):
                shown.append(self)

            def __enter__(self):
                return self

            def __exit__(self, *_):
                return None

            def update(self, percent):
                self.n += percent

        module = types.ModuleType("tqdm.auto")
        module.tqdm = Bar
        with unittest.mock.patch.dict(sys.modules, {"tqdm": module, "tqdm.auto": module}):
            self.scene.render(**SMALL, progress=True)
        self.assertEqual(shown[0].n, 100)
        with unittest.mock.patch.dict(sys.modules, {"tqdm": None, "tqdm.auto": None}):
            self.scene.render(**SMALL, progress=True)

    def test_a_split_map_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "map.png")
            self.picture.save_split_map(path, by="cause")
            self.assertEqual(path.read_bytes()[:4], b"\x89PNG")
            with self.assertRaises(ValueError):
                self.picture.save_split_map(path, by="colour")

    def test_a_trace_has_the_bits_of_the_picture(self):
        split = self.picture.split_map()
        y, x = (int(k) for k in np.argwhere(split.level > 0)[0])
        traced = asos.trace(self.scene, x, y, **SMALL)
        self.assertEqual(traced.level, split.level[y, x])
        np.testing.assert_array_equal(
            np.array(traced.radiance, np.float32), self.picture["beauty"][y, x]
        )
        self.assertEqual(traced.cells[0].side, 1.0)
        self.assertGreater(len(traced.cells), 1)

    def test_a_session_ends_with_the_picture(self):
        updates = 0
        for update in self.scene.session(**SMALL):
            updates += 1
            self.assertEqual(update.rgb.shape, (36, 64, 3))
        self.assertTrue(update.progress.finished)
        self.assertGreater(updates, 0)
        np.testing.assert_array_equal(update.rgb, self.picture["beauty"])

    def test_a_session_can_be_left(self):
        for _ in self.scene.session(width=640, height=360, eps=0.0):
            break

    def test_saves_and_shows_itself(self):
        self.assertEqual(self.picture._repr_png_()[:8], b"\x89PNG\r\n\x1a\n")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "a.exr"
            self.picture.save(path)
            self.assertGreater(path.stat().st_size, 1000)
            with self.assertRaises(asos.InvalidArgument):
                self.picture.save(path.with_suffix(".gif"))
            with self.assertRaises(asos.CannotWrite):
                self.picture.save(os.path.join(folder, "missing", "a.png"))

    def test_threads_render_at_once(self):
        found = [None] * 4

        def render(i):
            found[i] = self.scene.render(**SMALL, threads=1)["beauty"]

        threads = [threading.Thread(target=render, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for beauty in found:
            np.testing.assert_array_equal(beauty, self.picture["beauty"])


class Scenes(unittest.TestCase):
    def test_arrays_become_a_scene(self):
        red = asos.Material()
        red.base_color = (1, 0, 0, 1)
        red.unlit = True
        places = [np.eye(4), np.eye(4)]
        places[1][0, 3] = 2.0
        scene = asos.Scene([triangle(world_from_mesh=places)], [red])
        self.assertEqual(scene.triangles, 2)
        camera = asos.look_at((1.2, 0.4, 6), (1.2, 0.4, 0), 0.8)
        picture = scene.render(
            camera, width=60, height=30, ground="off", background="transparent"
        )
        # Each covers half a square metre of a view that is 2 * 6 * tan(0.4) metres high.
        share = 1.0 / (2 * (12 * np.tan(0.4)) ** 2)
        self.assertAlmostEqual(picture["alpha"].mean(), share, delta=1e-4 * share)
        np.testing.assert_allclose(picture["beauty"][..., 0], picture["alpha"], atol=1e-6)
        self.assertEqual(picture["beauty"][..., 1:].max(), 0)

    def test_a_camera_keeps_its_matrix(self):
        camera = asos.look_at((1, 2, 3), (1, 2, 0))
        np.testing.assert_allclose(camera.world_from_camera[:3, 3], (1, 2, 3))
        turned = np.eye(4)
        turned[0, 3] = 5
        camera.world_from_camera = turned
        np.testing.assert_array_equal(camera.world_from_camera, turned)
        with self.assertRaises(ValueError):
            camera.world_from_camera = np.eye(3)

    def test_other_lights_change_the_picture(self):
        scene = asos.load("builtin:boxes")
        lamp = asos.Light()
        lamp.position, lamp.intensity = (0, 5, 0), 100
        lit = scene.with_lights([lamp])
        self.assertGreater(asos.compare(scene.render(**SMALL), lit.render(**SMALL)).rmse, 0.01)


class Errors(unittest.TestCase):
    def test_files(self):
        with self.assertRaises(asos.CannotOpen) as raised:
            asos.load("missing.glb")
        self.assertIsInstance(raised.exception, OSError)
        self.assertEqual(raised.exception.subject, "missing.glb")

    def test_settings(self):
        scene = asos.load("builtin:boxes")
        for settings, expected in (
            ({"eps": 2.0}, asos.InvalidArgument),
            ({"eps": float("nan")}, asos.InvalidArgument),
            ({"method": "none such"}, asos.InvalidArgument),
            ({"colour": 1}, TypeError),
            ({"max": "four"}, TypeError),
            ({"ground": "sand"}, ValueError),
        ):
            with self.subTest(settings), self.assertRaises(expected):
                scene.render(**SMALL, **settings)

    def test_arrays(self):
        for mesh, expected in (
            (asos.Mesh(np.zeros((3, 2)), [[0, 1, 2]]), ValueError),
            (asos.Mesh(np.zeros((3, 3)), [[0, 1, 3]]), asos.InvalidArgument),
            (asos.Mesh(np.full((3, 3), np.nan), [[0, 1, 2]]), asos.InvalidArgument),
        ):
            with self.assertRaises(expected):
                asos.Scene([mesh])

    def test_an_exception_of_the_callback_stops_the_render(self):
        scene = asos.load("builtin:office")
        with self.assertRaises(KeyError):
            scene.render(width=640, height=360, progress=lambda progress: {}["nothing"])

    def test_ctrl_c_stops_the_render(self):
        scene = asos.load("builtin:office")

        def interrupt(progress):
            if progress.running:
                os.kill(os.getpid(), signal.SIGINT)

        with self.assertRaises(KeyboardInterrupt):
            scene.render(width=640, height=360, progress=interrupt)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], "-v"])
