# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""An add-on for Blender: cuts the active mesh object into the parts that a person would name."""

import functools
import importlib.util
import os
import pathlib
import platform
import re
import sys
import tempfile
import zipfile

import bmesh
import bpy
import numpy as np

bl_info = {
    "name": "Segment into Parts",
    "author": "The Spectral_segmentation authors",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "View3D > Object > Segment into Parts; View3D > Sidebar > Segment",
    "description": "Cuts a mesh into the parts that a person would name",
    "category": "Object",
}

ATTRIBUTE = "segment"
# What this add-on has made, also where Blender has added a number
OWN_NAME = re.compile(r"segment_\d{3,}(\.\d{3,})?$")


def unpack_wheel():
    """Lets Python find the package in the add-on's own wheel, as Blender does from 4.2 on."""
    if importlib.util.find_spec("spectral_segmentation"):
        return
    wheels = pathlib.Path(__file__).resolve().parent / "wheels"
    system = {"darwin": "macosx", "win32": "win"}.get(sys.platform, sys.platform)
    for wheel in wheels.glob("*-cp%d%d-*.whl" % sys.version_info[:2]):
        tag = wheel.stem.split("-")[-1]
        if system in tag and tag.endswith(platform.machine().lower()):
            folder = wheels / wheel.stem
            try:
                if not folder.is_dir(): # Python loads compiled code from a file of its own only.
                    with tempfile.TemporaryDirectory(dir=wheels) as unfinished:
                        unpacked = pathlib.Path(unfinished, "unpacked")
                        zipfile.ZipFile(wheel).extractall(unpacked)
                        unpacked.rename(folder)
            except (OSError, zipfile.BadZipFile) as error:
                raise ImportError("the add-on's wheel cannot be unpacked: %s" % error) from None
            sys.path.append(str(folder))
            return
    raise ImportError("the add-on has no wheel for Python %d.%d on %s %s" % (
        *sys.version_info[:2], platform.system(), platform.machine()))


def segment_name(label):
    return "segment_%03d" % label


def integers(collection, attribute):
    result = np.empty(len(collection), np.int32)
    collection.foreach_get(attribute, result)
    return result


def ply_of(mesh, scale):
    """The polygons as a file of PLY, which is read as the tool `segment_mesh` reads it."""
    points = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", points)
    if not np.isfinite(points).all():
        raise ValueError("the mesh has coordinates that are not finite")
    points = points.reshape(-1, 3) * np.asarray(scale, np.float32)
    polygons = np.insert(integers(mesh.loops, "vertex_index"),
                         integers(mesh.polygons, "loop_start"),
                         integers(mesh.polygons, "loop_total"))
    header = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\n"
              "property float y\nproperty float z\nelement face %d\n"
              "property list int int vertex_indices\nend_header\n"
              % (len(points), len(mesh.polygons)))
    return header.encode() + points.astype("<f4").tobytes() + polygons.astype("<i4").tobytes()


@functools.lru_cache(maxsize=2)
def search(ply, method, **limit):
    """The triangles of the mesh and the hierarchy of its cuts, of which a slider asks again."""
    import spectral_segmentation
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "mesh.ply")
        with open(path, "wb") as file:
            file.write(ply)
        mesh = spectral_segmentation.read(path)
    manager = bpy.context.window_manager
    manager.progress_begin(0, 100)
    try:
        hierarchy = spectral_segmentation.segment_hierarchy(
            mesh, method=method, progress=lambda share: manager.progress_update(100 * share),
            **limit)
    finally:
        manager.progress_end()
    return mesh, hierarchy


def segment_triangles(ply, method, number, threshold):
    """The triangles and their labels: those of `segment()`, if possible of a run that was made."""
    mesh, hierarchy = search(ply, method)
    if number is not None:
        if number > hierarchy.number_of_segments:
            mesh, hierarchy = search(ply, method, number_of_segments=number)
        return mesh, hierarchy.labels(number)
    if threshold is not None:
        try:
            return mesh, hierarchy.labels(salience_threshold=threshold)
        except ValueError: # cuts are needed that the run did not make
            return mesh, search(ply, method, salience_threshold=threshold)[1].labels()
    return mesh, hierarchy.labels()


def labels_of_polygons(mesh, labels, number_of_polygons):
    """For each polygon the label that has the largest area of its triangles."""
    a, b, c = (mesh.points[mesh.triangles[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1)
    number = labels.max() + 1
    pairs, first, place = np.unique(mesh.polygon_of_triangle.astype(np.int64) * number + labels,
                                    return_index=True, return_inverse=True)
    areas = np.bincount(place, area)
    result = np.zeros(number_of_polygons, np.int32)
    order = np.lexsort((-first, areas, pairs // number))
    result[pairs[order] // number] = pairs[order] % number # the last one of a polygon stays
    return result


def linear(colors):
    """Of 8 bits in sRGB, Blender's colors: linear, with the opacity."""
    c = colors / 255
    c = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return np.concatenate([c, np.ones((len(c), 1))], axis=1).tolist()


def write_attribute(object, labels, colors):
    attributes = object.data.attributes
    if ATTRIBUTE in attributes:
        attributes.remove(attributes[ATTRIBUTE])
    attributes.new(ATTRIBUTE, 'INT', 'FACE').data.foreach_set("value", labels)


def remove_own(groups):
    for group in [group for group in groups if OWN_NAME.match(group.name)]:
        groups.remove(group)


def write_face_maps(object, labels, colors):
    remove_own(object.face_maps)
    first = len(object.face_maps)
    for label in range(len(colors)):
        object.face_maps.new(name=segment_name(label))
    layers = object.data.face_maps
    (layers.active or layers.new()).data.foreach_set("value", first + labels)


def write_vertex_groups(object, labels, colors):
    remove_own(object.vertex_groups)
    vertices = integers(object.data.loops, "vertex_index")
    of_corner = np.repeat(labels, integers(object.data.polygons, "loop_total"))
    for label in range(len(colors)):
        group = object.vertex_groups.new(name=segment_name(label))
        group.add(np.unique(vertices[of_corner == label]).tolist(), 1, 'REPLACE')


def write_materials(object, labels, colors):
    slots = object.data.materials
    for i in reversed(range(len(slots))):
        if slots[i] is not None and OWN_NAME.match(slots[i].name):
            material = slots.pop(index=i)
            if material.users == 0:
                bpy.data.materials.remove(material)
    first = len(slots)
    for label, color in enumerate(linear(colors)):
        material = bpy.data.materials.new(segment_name(label))
        material.diffuse_color = color # in Solid mode
        material.use_nodes = True
        for node in material.node_tree.nodes:
            if node.type == 'BSDF_PRINCIPLED':
                node.inputs["Base Color"].default_value = color
        slots.append(material)
    object.data.polygons.foreach_set("material_index", first + labels)


def split(bm, labels):
    """Yields each label and a BMesh of its faces. To copy all for each would take longer."""
    present = np.unique(labels)
    if len(present) == 1:
        yield int(present[0]), bm
        return
    for side in (labels < present[len(present) // 2], labels >= present[len(present) // 2]):
        half = bm.copy()
        others = [face for face, is_kept in zip(half.faces, side.tolist()) if not is_kept]
        bmesh.ops.delete(half, geom=others, context='FACES')
        yield from split(half, labels[side])
        half.free()


def write_objects(object, labels, colors):
    """Makes copies of the object with the polygons of each label, and hides the object."""
    context = bpy.context
    collection = bpy.data.collections.new(object.name + " segments")
    context.scene.collection.children.link(collection)
    whole = bmesh.new()
    whole.from_mesh(object.data)
    loose = [vertex for vertex in whole.verts if not vertex.link_faces]
    bmesh.ops.delete(whole, geom=loose, context='VERTS')
    for label, bm in split(whole, labels):
        part = object.copy()
        part.name = object.name + " " + segment_name(label)
        part.data = object.data.copy()
        part.data.name = part.name
        bm.to_mesh(part.data)
        collection.objects.link(part)
        part.select_set(True)
        context.view_layer.objects.active = part
    whole.free()
    object.select_set(False)
    object.hide_set(True)


# What is written, in this order: the separate objects have what was written before.
RESULTS = [
    ('MATERIALS', "Materials", "A material for each part, unlike those of its neighbors",
     write_materials),
    ('VERTEX_GROUPS', "Vertex Groups", "A group of the vertices of each part", write_vertex_groups),
    ('FACE_MAPS', "Face Maps", "A face map for each part", write_face_maps),
    ('ATTRIBUTE', "Face Attribute", "The number of the part of each face, from 0, as the integer "
     "attribute 'segment'", write_attribute),
    ('OBJECTS', "Separate Objects", "An object for each part, in a collection of its own; the "
     "object itself is hidden", write_objects),
]
if "face_maps" not in bpy.types.Object.bl_rna.properties: # Blender 4
    RESULTS = [result for result in RESULTS if result[0] != 'FACE_MAPS']


class OBJECT_OT_segment_into_parts(bpy.types.Operator):
    """Cut the active mesh into the parts that a person would name"""

    bl_idname = "object.segment_into_parts"
    bl_label = "Segment into Parts"
    bl_options = {'REGISTER', 'UNDO'}

    choice: bpy.props.EnumProperty(
        name="Parts", items=[
            ('AUTOMATIC', "Automatic", "As many parts as the shape has"),
            ('NUMBER', "Number", "A given number of parts"),
            ('THRESHOLD', "Threshold", "All cuts of at least a given salience")])
    number: bpy.props.IntProperty(
        name="Number of Parts", default=5, min=1, soft_max=20,
        description="Up to 20 parts no new search is needed")
    salience_threshold: bpy.props.FloatProperty(
        name="Threshold", default=0.48, min=0, max=1, step=1,
        description="The smallest salience of a cut: the probability that people cut there. A "
                    "higher one gives fewer parts. If automatic, it is 0.40, and 0.54 in the "
                    "method of the paper")
    method: bpy.props.EnumProperty(
        name="Method", items=[
            ('CALIBRATED', "Calibrated", "Cuts where people cut"),
            ('PAPER', "Zhang and Liu 2005", "The method of the paper")])
    results: bpy.props.EnumProperty(
        name="Results", items=[result[:3] for result in RESULTS], default={'MATERIALS'},
        options={'ENUM_FLAG'}, description="What the parts become; more than one with Shift")

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Only in Object Mode")
        return context.mode == 'OBJECT'

    def draw(self, context):
        layout = self.layout
        layout.use_property_split = True
        layout.row().prop(self, "choice", expand=True)
        if self.choice == 'NUMBER':
            layout.prop(self, "number", slider=True)
        elif self.choice == 'THRESHOLD':
            layout.prop(self, "salience_threshold", slider=True)
        layout.prop(self, "method")
        layout.column().prop(self, "results")

    def segment(self, object):
        """The label of each polygon, and the colors of the parts. Nothing is written here."""
        if object is None or object.type != 'MESH':
            raise ValueError("the active object is no mesh")
        if object.library is not None or object.data.library is not None:
            raise ValueError("the object is linked from another file; make it local first")
        if len(object.data.polygons) == 0:
            raise ValueError("the mesh has no faces")
        scale = [abs(s) for s in object.matrix_world.to_scale()]
        if max(scale) - min(scale) <= 1e-6 * max(scale): # which is no matter of the shape
            scale = (1, 1, 1)
        mesh, labels = segment_triangles(
            ply_of(object.data, scale), self.method.lower(),
            self.number if self.choice == 'NUMBER' else None,
            # a property of 32 bits
            round(self.salience_threshold, 6) if self.choice == 'THRESHOLD' else None)
        from spectral_segmentation import segment_colors
        return (labels_of_polygons(mesh, labels, len(object.data.polygons)),
                segment_colors(mesh.triangles, labels))

    def execute(self, context):
        object = context.active_object
        try:
            unpack_wheel() # only now, so that the add-on can tell what is missing
            labels, colors = self.segment(object)
        except ImportError as error:
            self.report({'ERROR'}, "The Python package spectral_segmentation cannot be loaded; the "
                        "README of the add-on tells how to install it: %s" % error)
            return {'CANCELLED'}
        except (ValueError, OverflowError, MemoryError, OSError) as error:
            self.report({'ERROR'}, "Not segmented: %s" % error)
            return {'CANCELLED'}
        for identifier, _, _, write in RESULTS:
            if identifier in self.results:
                write(object, labels, colors)
        object.data.update()
        if self.choice != 'NUMBER':
            self.number = len(colors) # where the slider starts
        self.report({'INFO'}, "Number of parts: %d" % len(colors))
        return {'FINISHED'}


class VIEW3D_PT_segment_into_parts(bpy.types.Panel):
    bl_label = "Segment into Parts"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "Segment"

    def draw(self, context):
        self.layout.operator(OBJECT_OT_segment_into_parts.bl_idname, icon='MOD_EXPLODE')


def draw_menu(self, context):
    self.layout.separator()
    self.layout.operator(OBJECT_OT_segment_into_parts.bl_idname)


def register():
    bpy.utils.register_class(OBJECT_OT_segment_into_parts)
    bpy.utils.register_class(VIEW3D_PT_segment_into_parts)
    bpy.types.VIEW3D_MT_object.append(draw_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_menu)
    bpy.utils.unregister_class(VIEW3D_PT_segment_into_parts)
    bpy.utils.unregister_class(OBJECT_OT_segment_into_parts)
