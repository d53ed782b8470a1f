# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests the add-on in Blender, whose Python finds the package spectral_segmentation by PYTHONPATH:

    blender -b -noaudio --factory-startup -P segment_parts_in_blender.py -- SEGMENT_MESH MESHES

with the tool and the directory of CGAL's meshes."""

import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

import bpy
import numpy as np
import spectral_segmentation

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
import segment_parts # after the path is known

TOOL, MESHES = sys.argv[sys.argv.index("--") + 1:]
segment = bpy.ops.object.segment_into_parts
remove = bpy.ops.object.remove_segmentation
HAS_FACE_MAPS = "face_maps" in bpy.types.Object.bl_rna.properties


def add_object(name, points, faces):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(points, [], faces)
    result = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(result)
    result.select_set(True)
    bpy.context.view_layer.objects.active = result
    return result


def add_elephant():
    mesh = spectral_segmentation.read(os.path.join(MESHES, "elephant.off"))
    return add_object("Elephant", mesh.points.tolist(), mesh.triangles.tolist())


def add_suzanne():
    bpy.ops.mesh.primitive_monkey_add()
    return bpy.context.object


def faces_of(mesh):
    return [list(polygon.vertices) for polygon in mesh.polygons]


def points_of(mesh):
    return [tuple(vertex.co) for vertex in mesh.vertices]


def area_of(mesh):
    return sum(polygon.area for polygon in mesh.polygons)


def attribute_of(mesh):
    return [value.value for value in mesh.attributes["segment"].data]


def names(number):
    return ["segment_%03d" % label for label in range(number)]


def clear_scene():
    bpy.ops.wm.read_factory_settings(use_empty=True)


def assert_same(first, second, msg=None):
    """Replaces unittest's function, whose description of a difference takes minutes for a mesh."""
    if first != second:
        raise AssertionError(msg or "%.200r is not %.200r" % (first, second))


class Object_test(unittest.TestCase):

    def setUp(self):
        self.addTypeEqualityFunc(list, assert_same)
        self.addTypeEqualityFunc(set, assert_same)
        clear_scene()
        segment_parts.register()
        self.addCleanup(segment_parts.unregister)

    def labels(self, thing, **parameters):
        self.assertEqual(segment(results={'ATTRIBUTE'}, **parameters), {'FINISHED'})
        return attribute_of(thing.data)


class Labels(Object_test):

    def labels_of_tool(self, thing, *arguments):
        """Returns the labels of a file with the same polygons."""
        points, faces = points_of(thing.data), faces_of(thing.data)
        with tempfile.TemporaryDirectory() as folder:
            off = os.path.join(folder, "mesh.off")
            with open(off, "w") as file:
                print("OFF\n%d %d 0" % (len(points), len(faces)), file=file)
                for point in points:
                    print(*point, file=file)
                for face in faces:
                    print(len(face), *face, file=file)
            done = subprocess.run([TOOL, off, "--quiet", "--labels", "-", *arguments],
                                  stdout=subprocess.PIPE, check=True)
        return [int(label) for label in done.stdout.split()]

    def test_elephant_has_labels_of_segment(self):
        thing = add_elephant()
        points, triangles = points_of(thing.data), faces_of(thing.data)
        for given, parameters in (
                ({}, {}),
                ({'choice': 'NUMBER', 'number': 5}, {"number_of_segments": 5}),
                ({'choice': 'NUMBER', 'number': 30}, {"number_of_segments": 30}),
                ({'choice': 'THRESHOLD', 'salience_threshold': 0.7}, {"salience_threshold": 0.7}),
                ({'method': 'PAPER'}, {"method": "paper"}),
                ({'method': 'PAPER', 'choice': 'THRESHOLD', 'salience_threshold': 0.4},
                 {"method": "paper", "salience_threshold": 0.4}),
                ({'method': 'PAPER', 'choice': 'NUMBER', 'number': 7},
                 {"method": "paper", "number_of_segments": 7})):
            with self.subTest(given):
                expected = spectral_segmentation.segment(points, triangles, **parameters)
                self.assertEqual(self.labels(thing, **given), expected.tolist())

    def test_quadrilaterals_have_labels_of_tool(self):
        thing = add_suzanne()
        self.assertGreater(sum(len(face) == 4 for face in faces_of(thing.data)), 400)
        self.assertEqual(self.labels(thing), self.labels_of_tool(thing))
        for number in (3, 5, 12):
            self.assertEqual(self.labels(thing, choice='NUMBER', number=number),
                             self.labels_of_tool(thing, "--segments", str(number)))

    def test_large_polygons_have_labels_of_tool(self):
        thing = add_suzanne()
        modifier = thing.modifiers.new("Decimate", 'DECIMATE') # faces of many corners, some concave
        modifier.decimate_type = 'DISSOLVE'
        modifier.angle_limit = 0.5
        bpy.ops.object.modifier_apply(modifier=modifier.name)
        self.assertGreater(max(map(len, faces_of(thing.data))), 50)
        for number in (3, 8):
            self.assertEqual(self.labels(thing, choice='NUMBER', number=number),
                             self.labels_of_tool(thing, "--segments", str(number)))

    def test_number_is_the_number_of_parts(self):
        thing = add_elephant()
        for number in (1, 5, 11, 20, 25):
            labels = self.labels(thing, choice='NUMBER', number=number)
            self.assertEqual(sorted(set(labels)), list(range(number)))

    def test_scale_of_object_changes_its_shape(self):
        thing = add_elephant()
        even = self.labels(thing, choice='NUMBER', number=5)
        thing.scale = (3, 3, 3)
        bpy.context.view_layer.update()
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), even)
        thing.scale = (1, 1, -4)
        bpy.context.view_layer.update()
        points = np.array(points_of(thing.data), np.float32) * np.array([1, 1, 4], np.float32)
        expected = spectral_segmentation.segment(points, faces_of(thing.data), number_of_segments=5)
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), expected.tolist())

    def test_modifiers_and_shape_keys_that_keep_faces_change_the_shape(self):
        thing = add_elephant()
        before = self.labels(thing, choice='NUMBER', number=5)
        points, triangles = np.array(points_of(thing.data), np.float32), faces_of(thing.data)
        middle = (points[:, 2].min() + points[:, 2].max()) / 2
        points[points[:, 2] > middle, 2] += 3
        expected = spectral_segmentation.segment(points, triangles, number_of_segments=5).tolist()
        self.assertNotEqual(before, expected)

        thing.shape_key_add(name="Basis")
        key = thing.shape_key_add(name="Long")
        key.data.foreach_set("co", points.ravel())
        key.value = 1
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), expected)
        key.value = 0
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), before)
        thing.shape_key_clear()

        group = thing.vertex_groups.new(name="upper")
        group.add(np.flatnonzero(points[:, 2] > middle).tolist(), 1, 'REPLACE')
        modifier = thing.modifiers.new("Displace", 'DISPLACE')
        modifier.direction, modifier.mid_level, modifier.strength = 'Z', 0, 3
        modifier.vertex_group = "upper"
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), expected)
        modifier.show_viewport = False
        self.assertEqual(self.labels(thing, choice='NUMBER', number=5), before)

    def test_modifier_that_is_not_seen_is_left_out(self):
        thing = add_suzanne()
        before = self.labels(thing)
        thing.modifiers.new("Subdivision", 'SUBSURF').show_viewport = False
        self.assertEqual(self.labels(thing), before)

    def test_all_selected_meshes(self):
        elephant = add_elephant()
        expected = self.labels(elephant, choice='NUMBER', number=5)
        bpy.ops.object.light_add()
        light = bpy.context.object
        points = add_object("Points", [(0, 0, 0), (1, 0, 0)], [])
        suzanne = add_suzanne()
        other = add_elephant()
        for thing in (elephant, light, points, suzanne):
            thing.select_set(True)
        other.select_set(False)
        labels = self.labels(suzanne, choice='NUMBER', number=5)
        self.assertEqual(set(labels), set(range(5)))
        self.assertEqual(attribute_of(elephant.data), expected)
        self.assertNotIn("segment", other.data.attributes)


class Slider(Object_test):

    def setUp(self):
        super().setUp()
        segment_parts.searches.clear()
        self.searches = 0
        search = spectral_segmentation.segment_hierarchy

        def counted(*arguments, **parameters):
            self.searches += 1
            return search(*arguments, **parameters)

        spectral_segmentation.segment_hierarchy = counted
        self.addCleanup(setattr, spectral_segmentation, "segment_hierarchy", search)

    def test_one_search_for_all_numbers_and_thresholds(self):
        thing = add_elephant()
        self.labels(thing)
        for number in range(1, 21):
            self.labels(thing, choice='NUMBER', number=number)
        for threshold in (0, 0.2, 0.9, 1):
            self.labels(thing, choice='THRESHOLD', salience_threshold=threshold)
        self.assertEqual(self.searches, 1)

    def test_changed_mesh_is_searched_again(self):
        thing = add_elephant()
        self.labels(thing)
        thing.data.vertices[7].co.x += 0.01
        self.labels(thing)
        self.assertEqual(self.searches, 2)

    def test_slider_starts_at_number_that_was_found(self):
        thing = add_elephant()
        found = max(self.labels(thing)) + 1
        segment('EXEC_DEFAULT', True) # so that Blender registers it
        self.assertEqual(bpy.context.window_manager.operators[-1].number, found)


class Results(Object_test):

    def assert_has_parts(self, thing, number):
        """Each kind of result says the same as the attribute."""
        mesh = thing.data
        labels = np.array(attribute_of(mesh))
        self.assertEqual(sorted(set(labels)), list(range(number)))
        self.assertEqual([material.name for material in mesh.materials][-number:], names(number))
        first = len(mesh.materials) - number
        self.assertEqual([p.material_index for p in mesh.polygons], (first + labels).tolist())
        self.assertEqual([group.name for group in thing.vertex_groups][-number:], names(number))
        for label in range(number):
            group = thing.vertex_groups["segment_%03d" % label].index
            inside = {v.index for v in mesh.vertices for g in v.groups if g.group == group}
            self.assertEqual(inside, {v for p in mesh.polygons if labels[p.index] == label
                                      for v in p.vertices})
        labels_at = {}
        for polygon, label in zip(mesh.polygons, labels.tolist()):
            for key in polygon.edge_keys:
                labels_at.setdefault(key, set()).add(label)
        boundary = {key for key, labels in labels_at.items() if len(labels) > 1}
        self.assertEqual({edge.key for edge in mesh.edges if edge.use_seam}, boundary)
        self.assertEqual({edge.key for edge in mesh.edges if edge.use_edge_sharp}, boundary)
        if HAS_FACE_MAPS:
            maps = [face_map.name for face_map in thing.face_maps]
            self.assertEqual(maps[-number:], names(number))
            values = [value.value for value in mesh.face_maps.active.data]
            self.assertEqual(values, (len(maps) - number + labels).tolist())

    def all_results(self):
        results = {'MATERIALS', 'VERTEX_GROUPS', 'ATTRIBUTE', 'SEAMS', 'SHARP_EDGES'}
        return results | {'FACE_MAPS'} if HAS_FACE_MAPS else results

    def test_results_hold_faces_of_labels(self):
        for add in (add_suzanne, add_elephant):
            thing = add()
            segment(choice='NUMBER', number=5, results=self.all_results())
            self.assert_has_parts(thing, 5)
            clear_scene()

    def test_results_replace_those_before_and_nothing_else(self):
        thing = add_suzanne()
        thing.data.materials.append(bpy.data.materials.new("fur"))
        thing.vertex_groups.new(name="bones")
        if HAS_FACE_MAPS:
            thing.face_maps.new(name="grip")
        for number in (8, 5):
            segment(choice='NUMBER', number=number, results=self.all_results())
            self.assert_has_parts(thing, number)
        self.assertEqual([m.name for m in thing.data.materials], ["fur"] + names(5))
        self.assertEqual([g.name for g in thing.vertex_groups], ["bones"] + names(5))
        self.assertEqual([m.name for m in bpy.data.materials], ["fur"] + names(5))
        if HAS_FACE_MAPS:
            self.assertEqual([m.name for m in thing.face_maps], ["grip"] + names(5))

    def test_materials_have_colors_of_package(self):
        thing = add_elephant()
        segment()
        triangles = faces_of(thing.data)
        labels = spectral_segmentation.segment(points_of(thing.data), triangles)
        for material, color in zip(thing.data.materials,
                                   spectral_segmentation.segment_colors(triangles, labels)):
            shown = [255 * c for c in material.diffuse_color.from_scene_linear_to_srgb()] \
                if hasattr(material.diffuse_color, "from_scene_linear_to_srgb") else \
                [255 * (1.055 * c ** (1 / 2.4) - 0.055 if c > 0.0031308 else 12.92 * c)
                 for c in material.diffuse_color[:3]]
            np.testing.assert_allclose(shown, color, atol=0.01)
            node = material.node_tree.nodes["Principled BSDF"]
            self.assertEqual(node.inputs["Base Color"].default_value[:], material.diffuse_color[:])

    def test_names_of_the_user_stay(self):
        thing = add_suzanne()
        names_of_user = ["segment_000", "segment_007"]
        for name in names_of_user:
            thing.data.materials.append(bpy.data.materials.new(name))
            thing.vertex_groups.new(name=name)
        for number in (5, 3):
            segment(choice='NUMBER', number=number, results=self.all_results())
            self.assertEqual([m.name for m in thing.data.materials],
                             names_of_user + ["segment_000.001"] + names(number)[1:])
            self.assertEqual([g.name for g in thing.vertex_groups],
                             names_of_user + ["segment_000.001"] + names(number)[1:])
        thing.data.materials[3].name = "head"
        remove()
        self.assertEqual([m.name for m in thing.data.materials], names_of_user + ["head"])
        self.assertEqual([g.name for g in thing.vertex_groups], names_of_user)

    def test_remove_brings_everything_back(self):
        thing = add_suzanne()
        mesh = thing.data
        for name in ("fur", "eyes", "nose"):
            mesh.materials.append(bpy.data.materials.new(name))
        faces = len(mesh.polygons)
        before = (np.arange(faces) * 7 % 3).tolist()
        mesh.polygons.foreach_set("material_index", before)
        edges = list(range(0, len(mesh.edges), 3))
        for edge in edges:
            mesh.edges[edge].use_seam = mesh.edges[edge].use_edge_sharp = True
        attributes = mesh.attributes.keys()
        for number in (5, 8):
            segment(choice='NUMBER', number=number, results=self.all_results())
        with self.assertRaisesRegex(RuntimeError, "attribute 'segment' of yours"):
            del mesh["segment_parts"]
            segment(results={'ATTRIBUTE'})
        mesh["segment_parts"] = True
        mesh.polygons[0].material_index = 1 # The user gives a face another material meanwhile.
        before[0] = 1
        self.assertEqual(remove(), {'FINISHED'})
        self.assertEqual([p.material_index for p in mesh.polygons], before)
        self.assertEqual([edge.index for edge in mesh.edges if edge.use_seam], edges)
        self.assertEqual([edge.index for edge in mesh.edges if edge.use_edge_sharp], edges)
        self.assertEqual([m.name for m in mesh.materials], ["fur", "eyes", "nose"])
        self.assertEqual([m.name for m in bpy.data.materials], ["eyes", "fur", "nose"])
        self.assertEqual(len(thing.vertex_groups), 0)
        self.assertEqual(mesh.attributes.keys(), attributes)
        self.assertEqual((list(mesh.keys()), list(thing.keys())), ([], []))
        with self.assertRaisesRegex(RuntimeError, "No selected object has a segmentation"):
            remove()

    def test_objects_are_the_parts(self):
        for add in (add_suzanne, add_elephant):
            whole = add()
            whole.location = (1, 2, 3)
            whole.data.vertices.add(1) # of no face: in none of the parts
            points = points_of(whole.data)
            faces = [frozenset(points[v] for v in f) for f in faces_of(whole.data)]
            segment(choice='NUMBER', number=5, results={'ATTRIBUTE', 'MATERIALS', 'OBJECTS'})
            labels = attribute_of(whole.data)
            self.assertTrue(whole.hide_get())
            parts = bpy.data.collections[whole.name + " segments"].objects
            self.assertEqual([part.name for part in parts],
                             [whole.name + " " + name for name in names(5)])
            self.assertEqual(list(bpy.context.selected_objects), list(parts))
            for label, part in enumerate(parts):
                points = points_of(part.data)
                self.assertEqual({frozenset(points[v] for v in f) for f in faces_of(part.data)},
                                 {f for f, l in zip(faces, labels) if l == label})
                self.assertEqual(set(attribute_of(part.data)), {label})
                self.assertEqual({v for f in faces_of(part.data) for v in f},
                                 set(range(len(points))))
                self.assertEqual(part.location, whole.location)
            self.assertEqual(sum(len(part.data.polygons) for part in parts), len(faces))
            self.assertAlmostEqual(sum(area_of(part.data) for part in parts), area_of(whole.data),
                                   delta=1e-5 * area_of(whole.data))
            clear_scene()

    def test_undo_and_again(self):
        bpy.ops.ed.undo_push(message="nothing")
        add_suzanne()
        bpy.ops.ed.undo_push(message="a mesh")
        segment(choice='NUMBER', number=5, results=self.all_results())
        before = attribute_of(bpy.data.objects["Suzanne"].data)
        bpy.ops.ed.undo_push(message="its parts")
        bpy.ops.ed.undo()
        thing = bpy.data.objects["Suzanne"]
        self.assertNotIn("segment", thing.data.attributes)
        self.assertEqual((len(thing.data.materials), len(thing.vertex_groups)), (0, 0))
        segment(choice='NUMBER', number=5, results=self.all_results())
        self.assert_has_parts(thing, 5)
        self.assertEqual(attribute_of(thing.data), before)


class Errors(Object_test):

    def assert_error(self, message, **parameters):
        """Checks that the operator reports the message, and makes nothing."""
        everything = ("objects", "meshes", "materials", "collections")
        before = [len(getattr(bpy.data, name)) for name in everything]
        with self.assertRaisesRegex(RuntimeError, message):
            segment(results={'ATTRIBUTE', 'MATERIALS', 'OBJECTS'}, **parameters)
        self.assertEqual([len(getattr(bpy.data, name)) for name in everything], before)
        mesh = getattr(bpy.context.object, "data", None)
        if isinstance(mesh, bpy.types.Mesh):
            self.assertNotIn("segment", mesh.attributes)

    def test_no_object(self):
        self.assert_error("no object is selected")

    def test_object_that_is_no_mesh(self):
        bpy.ops.object.light_add()
        self.assert_error("Point: the object is no mesh")

    def test_no_result(self):
        add_suzanne()
        with self.assertRaisesRegex(RuntimeError, "no result is chosen"):
            segment(results=set())

    def test_modifiers_that_change_faces(self):
        thing = add_suzanne()
        thing.modifiers.new("Subdivision", 'SUBSURF')
        self.assert_error(r"Suzanne: modifiers \(Subdivision\) change its faces; apply them")
        bpy.ops.object.convert(target='MESH')
        self.assertEqual(segment(results={'ATTRIBUTE'}), {'FINISHED'})

    def test_mesh_without_faces(self):
        add_object("Points", [(0, 0, 0), (1, 0, 0)], [])
        self.assert_error("the mesh has no faces")

    def test_coordinates_that_are_not_finite(self):
        thing = add_suzanne()
        thing.data.vertices[3].co.x = float("nan")
        self.assert_error("coordinates that are not finite")

    def test_more_parts_than_triangles(self):
        add_object("Triangle", [(0, 0, 0), (1, 0, 0), (0, 1, 0)], [(0, 1, 2)])
        self.assert_error("2 parts are more than the 1 triangles", choice='NUMBER', number=2)

    def test_edit_mode(self):
        thing = add_suzanne()
        bpy.ops.object.mode_set(mode='EDIT')
        self.assert_error("Only in Object Mode")
        bpy.ops.object.mode_set(mode='OBJECT')
        self.assertNotIn("segment", thing.data.attributes)

    def test_linked_mesh(self):
        thing = add_suzanne()
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "library.blend")
            bpy.data.libraries.write(path, {thing})
            bpy.ops.object.delete()
            with bpy.data.libraries.load(path, link=True) as (there, here):
                here.objects = there.objects
            bpy.context.scene.collection.objects.link(here.objects[0])
            here.objects[0].select_set(True)
            self.assert_error("linked from another file")

    def test_package_that_is_missing(self):
        add_suzanne()
        segment_parts.searches.clear()
        sys.modules["spectral_segmentation"] = None
        try:
            self.assert_error("The Python package spectral_segmentation cannot be loaded")
        finally:
            sys.modules["spectral_segmentation"] = spectral_segmentation


class Description(unittest.TestCase):

    def test_version_equals_the_version_of_the_package(self):
        version = ".".join(map(str, segment_parts.bl_info["version"]))
        self.assertEqual(version, spectral_segmentation.__version__)


if __name__ == "__main__":
    done = unittest.main(argv=sys.argv[:1], exit=False)
    sys.exit(not done.result.wasSuccessful())
