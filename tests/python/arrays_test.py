"""Arrays in and out: what is refused, what is copied, what is kept alive."""
import gc
import unittest

import numpy as np
import odontoscope
from shapes import SQUARE, ball, box, circle, root


def resident_kilobytes():
    with open("/proc/self/status", encoding="ascii") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS:"))


class Refused(unittest.TestCase):
    def refused(self, points, cause, *words):
        with self.assertRaises(odontoscope.InputError) as caught:
            odontoscope.Contours([(0, SQUARE), (1, points)])
        error = caught.exception
        self.assertEqual(error.cause, cause, str(error))
        self.assertTrue(error.remedy, str(error))
        for word in ("contour 1 of those given",) + words:
            self.assertIn(word, str(error))

    def test_shapes_that_are_no_points(self):
        for shape in [(4,), (4, 3), (2, 4), (4, 2, 1), ()]:
            self.refused(np.zeros(shape), "wrong-shape", str(shape))

    def test_types_that_are_no_real_numbers(self):
        for points in [np.array(SQUARE, dtype=complex), np.array(SQUARE, dtype="U4"), np.array(SQUARE, dtype=object), np.array(SQUARE, dtype="M8[s]")]:
            self.refused(points, "wrong-type", points.dtype.name if points.dtype.kind == "O" else "not real numbers")

    def test_lists_that_are_ragged(self):
        self.refused([(0, 0), (1,), (1, 1)], "wrong-type")

    def test_masked_points(self):
        self.refused(np.ma.array(SQUARE, mask=[[0, 0], [1, 1], [0, 0], [0, 0]]), "wrong-type", "hidden")

    def test_what_is_not_finite(self):
        for value in (np.nan, np.inf, -np.inf):
            points = np.array(SQUARE, dtype=float)
            points[2, 1] = value
            self.refused(points, "not-finite", "(2, 1)", str(value))

    def test_a_buffer_that_was_released(self):
        view = memoryview(np.array(SQUARE, dtype=float))
        view.release()
        self.refused(view, "wrong-type", "released")

    def test_empty_contours_by_the_library(self):
        with self.assertRaises(odontoscope.InputError) as caught:
            odontoscope.Contours([(0, SQUARE), (1, np.zeros((0, 2)))])
        self.assertEqual((caught.exception.cause, caught.exception.place["slice"], caught.exception.place["contour"]), ("too-few-points", 1, 0))

    def test_heights_and_structures_that_are_none(self):
        for row in [("low", SQUARE), (None, SQUARE), (0, SQUARE, 3), (0,), SQUARE, 7]:
            with self.assertRaises(odontoscope.UsageError):
                odontoscope.Contours([row])
        with self.assertRaises(odontoscope.InputError) as caught:
            odontoscope.Contours([(0, SQUARE), (float("nan"), SQUARE)])
        self.assertEqual(caught.exception.cause, "not-finite")

    def test_volumes(self):
        for values, cause in [(np.zeros((3, 3)), "wrong-shape"), (np.zeros((3, 3, 3), dtype=complex), "wrong-type"), (np.full((3, 3, 3), np.nan), "not-finite"),
                              (np.full((3, 3, 3), 1e300), "not-finite"), (np.zeros((0, 3, 3)), "empty-volume"), (np.zeros((1, 3, 3)), "single-slice")]:
            with self.assertRaises(odontoscope.InputError) as caught:
                odontoscope.Volume(values)
            self.assertEqual(caught.exception.cause, cause)
        for options, cause in [({"spacing": (1, 1)}, "wrong-shape"), ({"spacing": (1, 1, 0)}, "bad-spacing"), ({"origin": (0, 0, np.inf)}, "not-finite"),
                               ({"direction": np.eye(2)}, "wrong-shape"), ({"direction": [[1, 0.5, 0], [0, 1, 0], [0, 0, 1]]}, "sheared-volume")]:
            with self.assertRaises(odontoscope.InputError) as caught:
                odontoscope.Volume(ball(), **options)
            self.assertEqual(caught.exception.cause, cause)

    def test_triangles(self):
        points = np.eye(3)
        for triangles, cause in [([(0, 1, 3)], "index-out-of-range"), ([(0, 1, -1)], "index-out-of-range"), ([(0.0, 1.0, 2.0)], "wrong-type"), ([(0, 1)], "wrong-shape")]:
            with self.assertRaises(odontoscope.InputError) as caught:
                odontoscope.check((points, triangles))
            self.assertEqual(caught.exception.cause, cause)


class TakenAsTheyAre(unittest.TestCase):
    def test_any_stride_order_and_width(self):
        plain = odontoscope.Contours(box())
        wide = np.zeros((8, 6))
        wide[::2, 1:5:3] = SQUARE
        for points in [wide[::2, 1:5:3], np.asfortranarray(SQUARE), np.array(SQUARE, dtype=">f4"), np.array(SQUARE, dtype=np.int8), np.array(SQUARE[::-1])[::-1],
                       np.array(SQUARE, dtype=np.longdouble), tuple(map(tuple, SQUARE))]:
            self.assertEqual(odontoscope.Contours([(0, points), (1, SQUARE)]), plain)

    def test_read_only(self):
        points = np.array(SQUARE, dtype=float)
        points.flags.writeable = False
        self.assertEqual(odontoscope.Contours([(0, points), (1, points)]), odontoscope.Contours(box()))

    def test_and_what_becomes_of_them_later_changes_nothing(self):
        points = np.array(SQUARE, dtype=float)
        stack = odontoscope.Contours([(0, points), (1, points)])
        points[:] = np.nan
        self.assertEqual(stack, odontoscope.Contours(box()))
        values = ball()
        volume = odontoscope.Volume(values)
        values[:] = 0
        self.assertEqual(float(volume.values.max()), 5)

    def test_volumes_lie_where_direction_says(self):
        values = ball()[:, :, ::-1].copy()
        values[7, 7, 3] = 99
        # x runs backwards in the file: voxel i lies at 14 - i
        volume = odontoscope.Volume(values, origin=(14, 0, 0), direction=np.diag([-1, 1, 1]))
        self.assertEqual(volume.origin, (0, 0, 0))
        self.assertEqual(tuple(np.argwhere(volume.values == 99)[0]), (7, 7, 11))
        # z and x exchanged
        turned = odontoscope.Volume(values.transpose(2, 1, 0), direction=[[0, 0, 1], [0, 1, 0], [-1, 0, 0]])
        self.assertEqual(turned.values.shape, (15, 15, 15))
        self.assertEqual(int((turned.values == 99).sum()), 1)


class Views(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.model = odontoscope.reconstruct(root())

    def arrays(self, solid):
        return {name: getattr(solid, name) for name in ("points", "triangles", "tetrahedron_points", "tetrahedra", "labels")}

    def test_have_shapes_and_types_as_documented(self):
        solid = self.model["tooth"]
        told = {name: (array.dtype.name, array.ndim, array.shape[1:]) for name, array in self.arrays(solid).items()}
        self.assertEqual(told, {"points": ("float64", 2, (3,)), "triangles": ("uint32", 2, (3,)), "tetrahedron_points": ("float64", 2, (3,)),
                                "tetrahedra": ("uint32", 2, (4,)), "labels": ("uint16", 1, ())})
        self.assertEqual(len(solid.labels), len(solid.tetrahedra))

    def test_are_no_copies(self):
        for name, array in self.arrays(self.model["tooth"]).items():
            again = getattr(self.model["tooth"], name)
            self.assertEqual(array.__array_interface__["data"], again.__array_interface__["data"], name)
            self.assertTrue(np.shares_memory(array, again), name)
            self.assertFalse(array.flags.owndata, name)

    def test_cannot_be_written(self):
        for name, array in self.arrays(self.model["tooth"]).items():
            with self.assertRaises(ValueError, msg=name):
                array[0] = 0
            with self.assertRaises(ValueError, msg=name):
                array.flags.writeable = True

    def test_outlive_the_model(self):
        model = odontoscope.reconstruct(root())
        kept = self.arrays(model["tooth"])
        copies = {name: array.copy() for name, array in kept.items()}
        stack = odontoscope.Contours(root())
        points = stack[3][0][1]
        points_then = points.copy()
        del model, stack
        gc.collect()
        odontoscope.reconstruct(root(12))   # takes what was given back
        for name, array in kept.items():
            np.testing.assert_array_equal(array, copies[name], name)
        np.testing.assert_array_equal(points, points_then)

    def test_tetrahedra_are_positive_and_fill_the_surface(self):
        solid = self.model["tooth"]
        a, b, c, d = (solid.tetrahedron_points[solid.tetrahedra[:, n]] for n in range(4))
        volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
        self.assertGreater(volumes.min(), 0)
        self.assertAlmostEqual(volumes.sum(), solid.volume, places=9)

    def test_neighbours_share_the_face_and_know_each_other(self):
        solid = self.model["tooth"]
        neighbours, tetrahedra = solid.neighbours, solid.tetrahedra
        self.assertEqual((neighbours.shape, neighbours.dtype.name), (tetrahedra.shape, "int64"))
        for number, (behind, corners) in enumerate(zip(neighbours, tetrahedra)):
            for corner, other in enumerate(behind):
                if other >= 0:
                    self.assertEqual(len(set(tetrahedra[other]) & (set(corners) - {corners[corner]})), 3)
                    self.assertIn(number, neighbours[other])
        self.assertEqual(int((neighbours < 0).sum()), len(solid.triangles), "what nothing lies behind is the surface")

    def test_of_contours_are_the_points_given(self):
        stack = odontoscope.Contours([(0, circle()), (1, circle(radius=2))])
        np.testing.assert_array_equal(stack[1][0][1], circle(radius=2))
        with self.assertRaises(IndexError):
            stack[2]
        self.assertEqual(len(stack[-2:]), 2)


class Leaks(unittest.TestCase):
    def grown(self, call, warm=200, calls=1000):
        for _ in range(warm):
            call()
        gc.collect()
        before = resident_kilobytes()
        for _ in range(calls):
            call()
        gc.collect()
        return resident_kilobytes() - before

    def test_there_are_none_over_a_thousand_calls(self):
        """A call that kept its stack of 2 x 2,000 points would grow by 64 MB, its views' owner with it."""
        many = circle(radius=5, corners=2000)

        def call():
            stack = odontoscope.Contours([(0, many), (1, many)])
            self.assertEqual(len(stack[1][0][1]), 2000)
            with self.assertRaises(odontoscope.InputError):
                odontoscope.Contours([(0, many)])

        self.assertLess(self.grown(call), 2000)

    def test_nor_of_models(self):
        """On all processors and on one: of an arena of its own for each call oneTBB would keep 7 MB."""
        for threads in (0, 1):
            def call():
                odontoscope.reconstruct(box(), threads=threads)["tooth"].tetrahedra.sum()

            self.assertLess(self.grown(call, warm=400), 1000, f"threads={threads}")


if __name__ == "__main__":
    unittest.main()
