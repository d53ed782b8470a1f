# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""An add-on for Blender: cuts mesh objects into the parts that a person would name."""

import importlib.util
import os
import pathlib
import platform
import sys
import tempfile
import threading
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
# The custom property of what this add-on has made; for materials and groups it has their names, so
# that those which the user renames are the user's.
MARK = "segment_parts"
FORMER_MATERIAL = "segment_former_material" # attribute of faces: the index of the slot


class Cancelled(Exception):
    """Ends a search from its progress function."""


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


def flags(collection, attribute):
    result = np.empty(len(collection), bool)
    collection.foreach_get(attribute, result)
    return result


def polygons_of(mesh):
    return (integers(mesh.loops, "vertex_index"), integers(mesh.polygons, "loop_start"),
            integers(mesh.polygons, "loop_total"))


def points_of(object, depsgraph):
    """Returns the points as they look. Raises ValueError if modifiers make other faces."""

    def read(mesh):
        points = np.empty(3 * len(mesh.vertices), np.float32)
        mesh.vertices.foreach_get("co", points)
        return points.reshape(-1, 3)

    if len(object.modifiers) == 0 and object.data.shape_keys is None:
        return read(object.data)
    evaluated = object.evaluated_get(depsgraph)
    mesh = evaluated.to_mesh()
    try:
        if not all(map(np.array_equal, polygons_of(mesh), polygons_of(object.data))):
            names = [modifier.name for modifier in object.modifiers if modifier.show_viewport]
            raise ValueError("modifiers (%s) change its faces; apply them by Object > Convert > "
                             "Mesh, or disable them in the viewport" % ", ".join(names))
        return read(mesh)
    finally:
        evaluated.to_mesh_clear()


def ply_of(object, depsgraph):
    """Returns the polygons as a PLY file, which the package reads as `segment_mesh` does."""
    points = points_of(object, depsgraph)
    if not np.isfinite(points).all():
        raise ValueError("the mesh has coordinates that are not finite")
    scale = [abs(s) for s in object.matrix_world.to_scale()]
    if max(scale) - min(scale) > 1e-6 * max(scale): # An even scale does not change the shape.
        points = points * np.asarray(scale, np.float32)
    corners, starts, totals = polygons_of(object.data)
    polygons = np.insert(corners, starts, totals)
    header = ("ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty float x\n"
              "property float y\nproperty float z\nelement face %d\n"
              "property list int int vertex_indices\nend_header\n" % (len(points), len(totals)))
    return header.encode() + points.astype("<f4").tobytes() + polygons.astype("<i4").tobytes()


searches = {} # the results that a slider asks for again, in the order of their last use


def search(ply, method, progress, **limit):
    """Returns the triangles of the mesh and the hierarchy of its cuts."""
    import spectral_segmentation
    key = (ply, method, *limit.items())
    found = searches.pop(key, None)
    if found is None:
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mesh.ply")
            with open(path, "wb") as file:
                file.write(ply)
            mesh = spectral_segmentation.read(path)
        found = mesh, spectral_segmentation.segment_hierarchy(mesh, method=method,
                                                              progress=progress, **limit)
    searches[key] = found
    return found


def segment_triangles(ply, method, number, threshold, progress):
    """Returns the triangles and the labels of `segment()`, if possible without a new search."""
    mesh, hierarchy = search(ply, method, progress)
    if number is not None:
        if number > len(mesh.triangles):
            raise ValueError("%d parts are more than the %d triangles of the mesh"
                             % (number, len(mesh.triangles)))
        if number > hierarchy.number_of_segments:
            mesh, hierarchy = search(ply, method, progress, number_of_segments=number)
        return mesh, hierarchy.labels(number)
    if threshold is not None:
        try:
            return mesh, hierarchy.labels(salience_threshold=threshold)
        except ValueError: # cuts are needed that the run did not make
            return mesh, search(ply, method, progress, salience_threshold=threshold)[1].labels()
    return mesh, hierarchy.labels()


def labels_of_polygons(mesh, labels, number_of_polygons):
    """Returns for each polygon the label that has the largest area of its triangles."""
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
    """Returns Blender's colors, linear and with the opacity, for 8 bits in sRGB."""
    c = colors / 255
    c = np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4)
    return np.concatenate([c, np.ones((len(c), 1))], axis=1).tolist()


def remove_layer(mesh, name):
    """Removes an attribute, and returns its values, or None if there is none."""
    layer = mesh.attributes.get(name)
    if layer is None:
        return None
    values = flags(layer.data, "value") if layer.data_type == 'BOOLEAN' else \
        integers(layer.data, "value")
    mesh.attributes.remove(layer)
    return values


def add_layer(mesh, name, data_type, domain, values):
    mesh.attributes.new(name, data_type, domain).data.foreach_set("value", values)


def remove_attribute(object):
    if MARK not in object.data:
        return False
    del object.data[MARK]
    return remove_layer(object.data, ATTRIBUTE) is not None


def write_attribute(object, labels, colors):
    remove_attribute(object)
    add_layer(object.data, ATTRIBUTE, 'INT', 'FACE', labels)
    object.data[MARK] = True


def remove_groups(owner, key, groups):
    names = owner.get(key)
    if names is None:
        return False
    for name in names.split("\n"):
        if name in groups:
            groups.remove(groups[name])
    del owner[key]
    return True


def add_groups(owner, key, groups, number):
    result = [groups.new(name=segment_name(label)) for label in range(number)]
    owner[key] = "\n".join(group.name for group in result)
    return result


def remove_face_maps(object):
    return remove_groups(object, MARK + "_face_maps", object.face_maps)


def write_face_maps(object, labels, colors):
    remove_face_maps(object)
    first = len(object.face_maps)
    add_groups(object, MARK + "_face_maps", object.face_maps, len(colors))
    layers = object.data.face_maps
    (layers.active or layers.new()).data.foreach_set("value", first + labels)


def remove_vertex_groups(object):
    # The mesh has the names of the groups, also for other objects with this mesh.
    return remove_groups(object.data, MARK + "_vertex_groups", object.vertex_groups)


def write_vertex_groups(object, labels, colors):
    remove_vertex_groups(object)
    vertices = integers(object.data.loops, "vertex_index")
    of_corner = np.repeat(labels, integers(object.data.polygons, "loop_total"))
    groups = add_groups(object.data, MARK + "_vertex_groups", object.vertex_groups, len(colors))
    for label, group in enumerate(groups):
        group.add(np.unique(vertices[of_corner == label]).tolist(), 1, 'REPLACE')


def remove_materials(object):
    """Removes the add-on's materials. Faces that have them get back their former materials."""
    mesh = object.data
    slots = mesh.materials
    is_own = np.array([slot is not None and slot.get(MARK) == slot.name for slot in slots], bool)
    former = remove_layer(mesh, FORMER_MATERIAL)
    if not is_own.any():
        return False
    index = np.minimum(integers(mesh.polygons, "material_index"), len(slots) - 1)
    index = np.where(is_own[index], 0 if former is None else former,
                     np.cumsum(~is_own)[index] - 1)
    for i in np.flatnonzero(is_own)[::-1].tolist():
        material = slots.pop(index=i)
        if material.users == 0:
            bpy.data.materials.remove(material)
    index = np.clip(index, 0, max(len(slots) - 1, 0)).astype(np.int32)
    mesh.polygons.foreach_set("material_index", index)
    return True


def write_materials(object, labels, colors):
    remove_materials(object)
    mesh = object.data
    add_layer(mesh, FORMER_MATERIAL, 'INT', 'FACE', integers(mesh.polygons, "material_index"))
    first = len(mesh.materials)
    for label, color in enumerate(linear(colors)):
        material = bpy.data.materials.new(segment_name(label))
        material[MARK] = material.name
        material.diffuse_color = color # in Solid mode
        material.use_nodes = True
        for node in material.node_tree.nodes:
            if node.type == 'BSDF_PRINCIPLED':
                node.inputs["Base Color"].default_value = color
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", first + labels)


def remove_edges(mesh, flag, layer):
    own = remove_layer(mesh, layer)
    if own is None:
        return False
    mesh.edges.foreach_set(flag, flags(mesh.edges, flag) & ~own)
    return True


def write_edges(mesh, labels, flag, layer):
    """Sets the flag of the edges between parts. An attribute keeps which edges did not have it."""
    remove_edges(mesh, flag, layer)
    edges = integers(mesh.loops, "edge_index")
    of_corner = np.repeat(labels, integers(mesh.polygons, "loop_total"))
    last = np.empty(len(mesh.edges), labels.dtype) # the label of one of the faces at each edge
    last[edges] = of_corner
    is_boundary = np.zeros(len(mesh.edges), bool)
    is_boundary[edges[last[edges] != of_corner]] = True
    before = flags(mesh.edges, flag)
    add_layer(mesh, layer, 'BOOLEAN', 'EDGE', is_boundary & ~before)
    mesh.edges.foreach_set(flag, before | is_boundary)


def write_seams(object, labels, colors):
    write_edges(object.data, labels, "use_seam", "segment_seam")


def remove_seams(object):
    return remove_edges(object.data, "use_seam", "segment_seam")


def write_sharp_edges(object, labels, colors):
    write_edges(object.data, labels, "use_edge_sharp", "segment_sharp")


def remove_sharp_edges(object):
    return remove_edges(object.data, "use_edge_sharp", "segment_sharp")


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


# The results in the order in which they are written: separate objects have the results before.
RESULTS = [
    ('MATERIALS', "Materials", "A material for each part, unlike those of its neighbors",
     write_materials, remove_materials),
    ('VERTEX_GROUPS', "Vertex Groups", "A group of the vertices of each part", write_vertex_groups,
     remove_vertex_groups),
    ('FACE_MAPS', "Face Maps", "A face map for each part", write_face_maps, remove_face_maps),
    ('ATTRIBUTE', "Face Attribute", "The number of the part of each face, from 0, as the integer "
     "attribute 'segment'", write_attribute, remove_attribute),
    ('SEAMS', "Seams", "A seam for UV unwrapping along the boundaries of parts", write_seams,
     remove_seams),
    ('SHARP_EDGES', "Sharp Edges", "Sharp edges along the boundaries of parts", write_sharp_edges,
     remove_sharp_edges),
    ('OBJECTS', "Separate Objects", "An object for each part, in a collection of its own; the "
     "object itself is hidden", write_objects, None),
]
if "face_maps" not in bpy.types.Object.bl_rna.properties: # Blender 4
    RESULTS = [result for result in RESULTS if result[0] != 'FACE_MAPS']


class Run:
    """A run for all selected objects. Only `search` may be called in another thread."""

    def __init__(self, operator, context):
        unpack_wheel() # only now, so that the add-on can report what is missing
        import spectral_segmentation # for an error before the run
        if not operator.results:
            raise ValueError("no result is chosen")
        self.method = operator.method.lower()
        self.number = operator.number if operator.choice == 'NUMBER' else None
        self.threshold = round(operator.salience_threshold, 6) \
            if operator.choice == 'THRESHOLD' else None # a property of 32 bits
        self.fraction = 0 # of the run that is done
        self.is_cancelled = False
        self.error = None
        self.inputs = []  # each object, its name, its number of polygons, and these as a PLY file
        self.outputs = [] # each object, the labels of its polygons, and the colors of its parts
        self.skipped = [] # the reasons
        depsgraph = context.evaluated_depsgraph_get()
        for object in context.selected_objects:
            try:
                check(object, operator.results)
                self.inputs.append((object, object.name, len(object.data.polygons),
                                    ply_of(object, depsgraph)))
            except ValueError as error:
                self.skipped.append("%s: %s" % (object.name, error))
        if not self.inputs:
            raise ValueError("; ".join(self.skipped) or "no object is selected")

    def search(self, report):
        """Finds the parts, and reports the fraction that is done. Calls nothing of Blender."""
        from spectral_segmentation import segment_colors
        for i, (object, name, number_of_polygons, ply) in enumerate(self.inputs):

            def progress(fraction):
                if self.is_cancelled:
                    raise Cancelled
                self.fraction = (i + fraction) / len(self.inputs)
                report(self.fraction)

            try:
                mesh, labels = segment_triangles(ply, self.method, self.number, self.threshold,
                                                 progress)
            except (ValueError, OverflowError) as error:
                self.skipped.append("%s: %s" % (name, error))
                continue
            self.outputs.append((object, labels_of_polygons(mesh, labels, number_of_polygons),
                                 segment_colors(mesh.triangles, labels)))
        if not self.outputs:
            raise ValueError("; ".join(self.skipped))

    def search_in_thread(self):
        try:
            self.search(lambda fraction: None)
        except BaseException as error: # finish() raises it.
            self.error = error


def check(object, results):
    """Raises ValueError if the object cannot be segmented."""
    if object.type != 'MESH':
        raise ValueError("the object is no mesh")
    if object.library is not None or object.data.library is not None:
        raise ValueError("the object is linked from another file; make it local first")
    if len(object.data.polygons) == 0:
        raise ValueError("the mesh has no faces")
    if 'ATTRIBUTE' in results and ATTRIBUTE in object.data.attributes and MARK not in object.data:
        raise ValueError("the mesh has an attribute '%s' of yours; rename that first" % ATTRIBUTE)


class OBJECT_OT_segment_into_parts(bpy.types.Operator):
    """Cut the selected meshes into the parts that a person would name"""

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
        name="Threshold", default=0.4, min=0, max=1, step=1,
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

    def report_error(self, error):
        if isinstance(error, ImportError):
            self.report({'ERROR'}, "The Python package spectral_segmentation cannot be loaded; the "
                        "README of the add-on describes how to install it: %s" % error)
        elif isinstance(error, (ValueError, OverflowError, MemoryError, OSError)):
            self.report({'ERROR'}, "Not segmented: %s" % error)
        else:
            raise error
        return {'CANCELLED'}

    def execute(self, context):
        manager = context.window_manager
        manager.progress_begin(0, 100)
        try:
            run = Run(self, context)
            run.search(lambda fraction: manager.progress_update(100 * fraction))
        except Exception as error:
            return self.report_error(error)
        finally:
            manager.progress_end()
        return self.write(context, run)

    def invoke(self, context, event):
        if bpy.app.background:
            return self.execute(context)
        try:
            self.run = Run(self, context)
        except Exception as error:
            return self.report_error(error)
        self.thread = threading.Thread(target=self.run.search_in_thread, daemon=True)
        self.thread.start()
        self.thread.join(0.2)
        if not self.thread.is_alive():
            return self.finish(context)
        manager = context.window_manager
        manager.progress_begin(0, 100)
        self.timer = manager.event_timer_add(0.1, window=context.window)
        manager.modal_handler_add(self)
        return {'RUNNING_MODAL'}

    def modal(self, context, event):
        if event.type == 'ESC' and event.value == 'PRESS':
            self.cancel(context)
            self.report({'INFO'}, "Cancelled: nothing is segmented")
            return {'CANCELLED'}
        if event.type == 'TIMER':
            if not self.thread.is_alive():
                self.end_modal(context)
                return self.finish(context)
            context.window_manager.progress_update(100 * self.run.fraction)
            context.workspace.status_text_set("Segment into Parts: %d %%     Esc: Cancel"
                                              % (100 * self.run.fraction))
        return {'RUNNING_MODAL'}

    def end_modal(self, context):
        context.window_manager.event_timer_remove(self.timer)
        context.window_manager.progress_end()
        context.workspace.status_text_set(None)

    def cancel(self, context):
        """Ends the run; Blender calls this too. The thread ends at its next call of progress."""
        self.run.is_cancelled = True
        self.end_modal(context)

    def finish(self, context):
        if self.run.error is not None:
            return self.report_error(self.run.error)
        return self.write(context, self.run)

    def write(self, context, run):
        active = context.active_object
        for object, labels, colors in run.outputs:
            for identifier, _, _, write, _ in RESULTS:
                if identifier in self.results:
                    write(object, labels, colors)
            object.data.update()
        while len(searches) > 2 * len(run.inputs):
            del searches[next(iter(searches))]
        numbers = {object.name: len(colors) for object, _, colors in run.outputs}
        total = sum(numbers.values())
        if self.choice != 'NUMBER': # where the slider starts
            self.number = numbers.get(active.name if active else None, max(numbers.values()))
        for reason in run.skipped:
            self.report({'WARNING'}, "Skipped %s" % reason)
        self.report({'INFO'}, "Number of parts: %d" % total if len(numbers) == 1 else
                    "Number of parts: %d in %d objects" % (total, len(numbers)))
        return {'FINISHED'}


class OBJECT_OT_remove_segmentation(bpy.types.Operator):
    """Remove what Segment into Parts has made of the selected meshes, but separate objects"""

    bl_idname = "object.remove_segmentation"
    bl_label = "Remove Segmentation"
    bl_options = {'REGISTER', 'UNDO'}

    @classmethod
    def poll(cls, context):
        cls.poll_message_set("Only in Object Mode")
        return context.mode == 'OBJECT'

    def execute(self, context):
        number = 0
        for object in context.selected_objects:
            if object.type == 'MESH' and object.library is None and object.data.library is None:
                removed = [remove(object) for *_, remove in RESULTS if remove is not None]
                number += any(removed)
                object.data.update()
        if number == 0:
            self.report({'ERROR'}, "No selected object has a segmentation")
            return {'CANCELLED'}
        self.report({'INFO'}, "Segmentations removed: %d" % number)
        return {'FINISHED'}


class VIEW3D_PT_segment_into_parts(bpy.types.Panel):
    bl_label = "Segment into Parts"
    bl_space_type = 'VIEW_3D'
    bl_region_type = 'UI'
    bl_category = "Segment"

    def draw(self, context):
        self.layout.operator(OBJECT_OT_segment_into_parts.bl_idname, icon='MOD_EXPLODE')
        self.layout.operator(OBJECT_OT_remove_segmentation.bl_idname, icon='X')


def draw_menu(self, context):
    self.layout.separator()
    self.layout.operator(OBJECT_OT_segment_into_parts.bl_idname)
    self.layout.operator(OBJECT_OT_remove_segmentation.bl_idname)


CLASSES = [OBJECT_OT_segment_into_parts, OBJECT_OT_remove_segmentation,
           VIEW3D_PT_segment_into_parts]


def register():
    for cls in CLASSES:
        bpy.utils.register_class(cls)
    bpy.types.VIEW3D_MT_object.append(draw_menu)


def unregister():
    bpy.types.VIEW3D_MT_object.remove(draw_menu)
    for cls in reversed(CLASSES):
        bpy.utils.unregister_class(cls)
