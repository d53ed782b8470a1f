#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of benchmark/fit_part_salience.py."""
import pathlib
import re
import sys
import tempfile
import types
import unittest

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
sys.modules.setdefault("spectral_segmentation", types.ModuleType("none"))  # no run is made
import fit_part_salience as fit  # noqa: E402


def factors(**changed):
    return {**dict.fromkeys(fit.NAMES, 0.5), "is_boundary": True, **changed}


def tree_of_four_faces(truths):
    """Returns two halves of two faces, the first of which is cut further."""
    parents, children = [None, 0, 0, 1, 1], [[1, 2], [3, 4], [], [], []]
    nodes = [{"parent": parent, "children": c, "factors": factors() if c else None,
              "salience": 0.6 - 0.4 * i if c else None}
             for i, (parent, c) in enumerate(zip(parents, children))]
    hierarchy = {"nodes": nodes, "leaf_of_face": [3, 4, 2, 2], "salience_threshold": 0.5}
    return fit.Tree(hierarchy, [np.array(t) for t in truths], np.full(4, 0.25))


def pairs_that_differ(a, b):
    together = [np.equal.outer(x, x) for x in (np.array(a), np.array(b))]
    return (together[0] != together[1]).mean()


class Test(unittest.TestCase):
    def test_errors_are_fractions_of_pairs(self):
        truths = [[0, 0, 1, 1], [0, 1, 1, 1]]
        tree = tree_of_four_faces(truths)
        for outputs, labels in (([-1, 1], [0, 0, 0, 0]), ([1, -1], [0, 0, 1, 1]),
                                ([1, 2], [0, 1, 2, 2])):
            expected = np.mean([pairs_that_differ(labels, truth) for truth in truths])
            segments = tree.segments(np.array(outputs))
            self.assertAlmostEqual(tree.error(segments), expected)
            self.assertEqual(len(segments), len(set(labels)))
            self.assertEqual(tree.segments(np.array([3, 2]), len(segments)), segments)
        np.testing.assert_allclose(tree.choice_of_package, [0.1, -0.3])

    def test_gains_by_hand(self):
        tree = tree_of_four_faces([[0, 0, 1, 1]])
        tree.set_gains(0)
        np.testing.assert_allclose(tree.gains, [0.5, -0.125])
        np.testing.assert_allclose(tree.agreement, [1, 0])
        self.assertAlmostEqual(tree.error(tree.segments(tree.gains)), 0)
        # The first cut makes two parts of none, as half of the mesh is no part yet. The second cut
        # makes none of one.
        tree.set_gains(0.1)
        np.testing.assert_allclose(tree.gains, [0.5 + 0.1 * (2 * 0.65 + 0.35),
                                                -0.125 - 0.1 * (0.65 + 2 * 0.35)])
        # The first cut costs the pairs that it separates, but it makes the second one possible.
        tree = tree_of_four_faces([[0, 1, 1, 1]])
        tree.set_gains(0)
        np.testing.assert_allclose(tree.gains, [0.125, 0.125])
        np.testing.assert_allclose(tree.agreement, [0.5, 1])

    def test_measures_by_hand(self):
        tree = tree_of_four_faces([[0, 1, 1, 1], [0, 0, 0, 0]])
        # The halves: one of two faces has 2 of 3 in common with a part, the other 1 of 2; and both
        # are halves of the whole.
        measures = tree.measures(tree.segments(np.array([1, -1])))
        np.testing.assert_allclose(measures[1:], [2 / 3 / 2 / 2, 1, 0, 0, 2])
        tree = tree_of_four_faces([[0, 0, 1, 1]])
        measures = tree.measures(tree.segments(np.array([1, 1])))
        np.testing.assert_allclose(measures[1:], [2 / 5, 1, 0, 0, 3])
        measures = tree_of_four_faces([[0, 0, 0, 0]]).measures([3, 4, 2])
        np.testing.assert_allclose(measures[1:], [0, 1 / 3, 2, 0, 3])

    def test_a_cut_is_limited_by_the_cut_above_it(self):
        tree = tree_of_four_faces([[0, 0, 1, 1]])
        np.testing.assert_allclose(tree.limited_by_parents([0.25, 0.5]), [0.25, 0.25])
        np.testing.assert_allclose(tree.limited_by_parents([0.25, -0.5]), [0.25, -0.5])

    def test_between_components_the_package_decides(self):
        tree = tree_of_four_faces([[0, 0, 1, 1]])
        tree.is_boundary[1] = False
        outputs = tree.outputs(lambda x: np.full(len(x), 7.))
        self.assertEqual(outputs[0], 7)
        self.assertLess(outputs[1], -100)

    def test_inputs_are_found_by_their_names(self):
        self.assertEqual(len(set(fit.NAMES)), 15)
        numbers = fit.inputs(factors(size=0.25, log_relative_part_area=-1, roundness=0.75))
        self.assertEqual(numbers[fit.NAMES.index("roundness")], 0.75)
        self.assertAlmostEqual(numbers[-1], np.log(0.25) - 1)

    def test_gains_count_by_their_size(self):
        x = np.repeat([[0., 0.], [1., 0.], [0., 1.], [1., 1.]], 10, 0)
        is_gain = np.tile([1.] + 9 * [0.], 4)  # one of ten
        is_large = is_gain == (x[:, 0] != x[:, 1])
        network = fit.Network(x, is_gain, np.where(is_large, 100., 1.))
        np.testing.assert_array_equal(network(x) > 0, x[:, 0] != x[:, 1])
        before = network(x)
        network.calibrate(2, -1)
        np.testing.assert_allclose(network(x), 2 * before - 1)
        step = 1e-6 * network.deviations[0]
        slopes = (network(x + [step, 0]) - network(x - [step, 0])) / 2e-6
        self.assertAlmostEqual(network.mean_changes(x)[0], slopes.mean(), places=5)

    def test_calibration_finds_the_logistic_function(self):
        outputs = np.linspace(-4, 4, 50)
        found = fit.fit_calibration(outputs, 1 / (1 + np.exp(-0.5 * outputs + 1)))
        np.testing.assert_allclose(found, [0.5, -1], atol=1e-4)

    def test_copies_keep_the_faces(self):
        points = np.array([[0, 0, 0], [3, 0, 0], [0, 4, 0], [0, 0, 5]], float)
        mesh = fit.Mesh(points, np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]))
        fine = fit.subdivided(mesh)
        self.assertEqual(len(fine.points), 10)
        normals = np.tile(mesh.normals() / 4, (4, 1))  # four triangles of each, in its plane
        np.testing.assert_allclose(fine.normals(), normals)
        distance = np.linalg.norm(fine.centroids() - np.tile(mesh.centroids(), (4, 1)), axis=1)
        self.assertLess(distance.max(), 2)
        changed = fit.stretched_and_noisy(mesh, 1)
        np.testing.assert_array_equal(changed.triangles, mesh.triangles)
        np.testing.assert_array_equal(changed.points, fit.stretched_and_noisy(mesh, 1).points)

    def test_plain_shapes_are_closed_tubes_and_plates(self):
        shapes = fit.plain_shapes()
        for shape in shapes:
            edges = {(t[k], t[k - 2]) for t in shape.mesh.triangles for k in range(3)}
            self.assertEqual(len(edges), 3 * len(shape.mesh.triangles))  # each once per direction
            is_closed = all((b, a) in edges for a, b in edges)
            n, m = len(shape.mesh.points), len(shape.mesh.triangles)
            if is_closed:
                self.assertIn(2 * n - m, (0, 4))  # of a torus, or of a sphere
            self.assertEqual(set(shape.truths[0]), {0})
        torus = shapes[0].mesh  # of the radii 3 and 0.4
        volume = np.einsum("ij,ij->", torus.points[torus.triangles[:, 0]], np.cross(
            torus.points[torus.triangles[:, 1]], torus.points[torus.triangles[:, 2]])) / 6
        self.assertAlmostEqual(volume / (2 * np.pi ** 2 * 3 * 0.4 ** 2), 1, delta=0.12)

    def test_machines_are_closed_and_have_their_parts(self):
        numbers = []
        for machine in fit.machines():
            t = machine.mesh.triangles
            edges = {(a[k], a[k - 2]) for a in t for k in range(3)}
            self.assertEqual(len(edges), 3 * len(t))
            self.assertEqual(len(machine.truths[0]), len(t))
            numbers.append(machine.truths[0].max() + 1)
            if len(numbers) % 11 != 0:  # the last of each size is a strip
                self.assertTrue(all((b, a) in edges for a, b in edges))
        self.assertEqual(numbers[:11], [2, 3, 3, 2, 3, 1, 13, 1, 2, 5, 1])
        flange = fit.machines()[0].mesh
        volume = np.einsum("ij,ij->", flange.points[flange.triangles[:, 0]], np.cross(
            flange.points[flange.triangles[:, 1]], flange.points[flange.triangles[:, 2]])) / 6
        polygon = 24 / 2 * np.sin(2 * np.pi / 24)  # instead of pi
        self.assertAlmostEqual(abs(volume), polygon * (9 * 0.4 + 1.2 ** 2 * 2.6))

    def test_solids_of_cones_have_their_volumes_and_parts(self):
        a, b, c = np.array([0., 0, 0]), np.array([20., 0, 0]), np.array([10., 0, 20])
        mesh, part = fit.solid_of_cones([[(a, b, 6, 6)], [((a + b) / 2, c, 3, 3)]])
        edges = {(t[k], t[k - 2]) for t in mesh.triangles for k in range(3)}
        self.assertTrue(all((b, a) in edges for a, b in edges))
        x, y, z = (mesh.points[mesh.triangles[:, k]] for k in range(3))
        bar = np.pi * 6 ** 2 * (20 + 4 / 3 * 6)
        peg = np.pi * 3 ** 2 * (14 + 2 / 3 * 3)  # 14 from the top of the bar to the upper center
        volume = np.einsum("ij,ij->", x, np.cross(y, z)) / 6
        self.assertAlmostEqual(volume / (bar + peg), 1, delta=0.04)
        areas = mesh.shares_of_area()
        of_bar = 2 * np.pi * 6 * (20 + 2 * 6) - np.pi * 3 ** 2
        of_peg = 2 * np.pi * 3 * (14 + 3)
        self.assertAlmostEqual(areas[part == 1].sum(), of_peg / (of_bar + of_peg), delta=0.03)

    def test_creatures_are_closed_and_their_torso_touches_their_limbs(self):
        for seed, number_of_limbs in ((0, 5), (1, 5), (2, 4)):
            mesh, part = fit.creature(seed)
            face_at = {(t[k], t[k - 2]): i for i, t in enumerate(mesh.triangles) for k in range(3)}
            self.assertEqual(len(face_at), 3 * len(mesh.triangles))
            self.assertTrue(all((b, a) in face_at for a, b in face_at))
            touched = {part[face_at[b, a]] for (a, b), i in face_at.items() if part[i] == 0}
            self.assertGreaterEqual(len(touched - {0}), number_of_limbs)

    def test_the_table_has_all_numbers(self):
        random = np.random.default_rng(1)
        x = random.normal(size=(100, len(fit.NAMES) + 1))
        network = fit.Network(x, x[:, 0] > 0, np.ones(100))
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "table.h"
            fit.write_table(file, network)
            text = file.read_text()
        before, table = text.split("calibrated_boundary_network = ")
        self.assertIn("merging_network = ", before) # it is kept
        numbers = [float(n) for n in re.findall(r"-?\d+\.\d{5}", table)]
        expected = [*network.means, *network.deviations, network.constant, *network.linear]
        for unit in zip(network.bias, network.hidden.T, network.out):
            expected += [unit[0], *unit[1], unit[2]]
        np.testing.assert_allclose(numbers, expected, atol=6e-6)
        self.assertTrue(text.endswith("CALIBRATED_NETWORKS_H\n"))
        self.assertLessEqual(max(map(len, text.splitlines())), 100)


if __name__ == "__main__":
    unittest.main()
