#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Renders meshes with colored faces, as segment_mesh writes them, to PNG pictures.

  render.py elephant.ply                      writes elephant.png
  render.py elephant.ply -o picture.png
  render.py *.ply --sheet -o sheet.png        one picture of them all, with their names

Needs VTK for Python and a display; without one, it starts itself again under xvfb-run.
"""

import argparse
import math
import os
import pathlib
import shutil
import sys

try:
    import vtk
except ModuleNotFoundError:
    sys.exit("render.py: Python has no VTK; scripts/setup.sh pictures installs it")


def parse_arguments():
    parser = argparse.ArgumentParser(
        description="Renders meshes with colored faces (PLY) to PNG pictures.")
    parser.add_argument("meshes", nargs="+", metavar="PLY")
    parser.add_argument("-o", "--output", metavar="PNG",
                        help="default: the name of the mesh, ending in .png")
    parser.add_argument("--sheet", action="store_true", help="all meshes in one picture")
    parser.add_argument("--columns", type=int, metavar="N",
                        help="of the sheet; default: as many as rows")
    parser.add_argument("--size", type=int, nargs=2, default=(800, 600), metavar=("W", "H"),
                        help="of the picture of one mesh, in pixels [800 600]")
    parser.add_argument("--up", choices=["x", "y", "z", "-x", "-y", "-z", "pca"], default="y",
                        help="the direction that is up in the picture; pca: that in which the mesh "
                             "is longest, with its broad side in front [y]")
    parser.add_argument("--azimuth", type=float, default=30,
                        help="degrees by which the camera turns around the mesh [30]")
    parser.add_argument("--elevation", type=float, default=20,
                        help="degrees that the camera is above the mesh [20]")
    parser.add_argument("--edges", action="store_true", help="draw the edges of the faces")
    arguments = parser.parse_args()
    if arguments.output and len(arguments.meshes) > 1 and not arguments.sheet:
        parser.error("-o names one picture: give one mesh, or --sheet")
    if arguments.sheet and not arguments.output:
        parser.error("--sheet needs -o")
    if arguments.columns is not None and arguments.columns < 1:
        parser.error("--columns must be at least 1")
    for mesh in arguments.meshes:
        if not os.path.isfile(mesh):
            parser.error("there is no file " + mesh)
    return arguments


def ensure_display():
    if os.environ.get("DISPLAY"):
        return
    if not shutil.which("xvfb-run"):
        sys.exit("render.py: there is no display, and no xvfb-run (Debian package xvfb)")
    os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 640x480x24",
                           sys.executable, *sys.argv])


def read_mesh(path):
    with open(path, "rb") as file:
        if file.read(3).lower() != b"ply":
            sys.exit("render.py: %s is no PLY; segment_mesh %s -o OUT.ply makes one, with a color "
                     "for each part" % (path, path))
    reader = vtk.vtkPLYReader()
    reader.SetFileName(path)
    reader.Update()
    mesh = reader.GetOutput()
    if mesh.GetNumberOfCells() == 0:
        sys.exit("render.py: " + path + " has no faces")
    return mesh


def actor_of(mesh, with_edges):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(mesh)
    # Colors of faces are an array of the cells, that of this name in VTK's reader of PLY.
    for name in ("RGBA", "RGB"):
        if mesh.GetCellData().HasArray(name):
            mapper.SetScalarModeToUseCellFieldData()
            mapper.SelectColorArray(name)
            mapper.SetColorModeToDirectScalars()
            break
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    material = actor.GetProperty()
    material.SetInterpolationToFlat()
    material.SetColor(0.8, 0.8, 0.8)
    material.SetAmbient(0.25)
    material.SetDiffuse(0.75)
    material.SetSpecular(0.05)
    if with_edges:
        material.EdgeVisibilityOn()
        material.SetEdgeColor(0.2, 0.2, 0.2)
        material.SetLineWidth(0.5)
    return actor


def upward_and_frontal(mesh, up):
    """Returns the directions that are up and toward a viewer in front of the mesh."""
    if up == "pca":
        corner, longest, middle, shortest, sizes = ([0, 0, 0] for _ in range(5))
        vtk.vtkOBBTree.ComputeOBB(mesh.GetPoints(), corner, longest, middle, shortest, sizes)
        return tuple(vector if max(vector, key=abs) > 0 else [-x for x in vector]
                     for vector in (longest, shortest))
    upward, frontal = [0, 0, 0], [0, 0, 0]
    axis = "xyz".index(up[-1])
    upward[axis] = -1 if up[0] == "-" else 1
    frontal[(axis + 1) % 3] = 1
    return upward, frontal


def set_camera(renderer, mesh, up, azimuth, elevation):
    upward, frontal = upward_and_frontal(mesh, up)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*frontal)
    camera.SetViewUp(*upward)
    camera.Azimuth(azimuth)
    camera.Elevation(elevation)
    camera.SetViewAngle(20)


def add_lights(renderer):
    for x, y, intensity in ((-0.6, 0.9, 0.75), (0.9, 0.2, 0.35), (0, 0, 0.25)):
        light = vtk.vtkLight()
        light.SetLightTypeToCameraLight()
        light.SetPosition(x, y, 1)
        light.SetIntensity(intensity)
        renderer.AddLight(light)


def blank_renderer():
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    return renderer


def renderer_of(path, arguments):
    mesh = read_mesh(path)
    renderer = blank_renderer()
    renderer.AddActor(actor_of(mesh, arguments.edges))
    renderer.AutomaticLightCreationOff()
    add_lights(renderer)
    set_camera(renderer, mesh, arguments.up, arguments.azimuth, arguments.elevation)
    fill_view(renderer, mesh, arguments.size[0] / arguments.size[1])
    return renderer


def fill_view(renderer, mesh, aspect):
    """Moves the camera so that the mesh, not its bounding sphere, fills the picture."""
    camera = renderer.GetActiveCamera()
    to_view = camera.GetViewTransformMatrix()
    points = [to_view.MultiplyPoint((*mesh.GetPoint(i), 1))[:3]
              for i in range(mesh.GetNumberOfPoints())]
    # From (cx, cy, cz) a point is in view if |x - cx| <= width * (cz - z), and so for y and height.
    height = 0.94 * math.tan(math.radians(camera.GetViewAngle() / 2))
    width = aspect * height
    right = max(x + width * z for x, y, z in points)
    left = max(-x + width * z for x, y, z in points)
    top = max(y + height * z for x, y, z in points)
    bottom = max(-y + height * z for x, y, z in points)
    position = ((right - left) / 2, (top - bottom) / 2,
                max((right + left) / (2 * width), (top + bottom) / (2 * height)))
    nearest = max(z for x, y, z in points)
    to_world = vtk.vtkMatrix4x4()
    vtk.vtkMatrix4x4.Invert(to_view, to_world)
    camera.SetPosition(*to_world.MultiplyPoint((*position, 1))[:3])
    camera.SetFocalPoint(*to_world.MultiplyPoint((*position[:2], nearest, 1))[:3])
    renderer.ResetCameraClippingRange()


def add_caption(renderer, text):
    caption = vtk.vtkTextActor()
    caption.SetInput(text)
    caption.GetTextProperty().SetColor(0, 0, 0)
    caption.GetTextProperty().SetFontSize(18)
    caption.SetPosition(8, 6)
    renderer.AddActor2D(caption)


def write_picture(renderers, size, output, columns=None):
    columns = columns or math.ceil(math.sqrt(len(renderers)))
    rows = math.ceil(len(renderers) / columns)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(columns * size[0], rows * size[1])
    for i in range(rows * columns):
        row, column = divmod(i, columns)
        renderer = renderers[i] if i < len(renderers) else blank_renderer()
        renderer.SetViewport(column / columns, 1 - (row + 1) / rows,
                             (column + 1) / columns, 1 - row / rows)
        window.AddRenderer(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(str(output))
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()
    window.Finalize()
    if writer.GetErrorCode() != 0:
        sys.exit("render.py: cannot write " + str(output))


def main():
    arguments = parse_arguments()
    ensure_display()
    if arguments.sheet:
        renderers = []
        for mesh in arguments.meshes:
            renderers.append(renderer_of(mesh, arguments))
            add_caption(renderers[-1], pathlib.Path(mesh).stem)
        write_picture(renderers, arguments.size, arguments.output, arguments.columns)
        return
    for mesh in arguments.meshes:
        output = arguments.output or pathlib.Path(mesh).with_suffix(".png")
        write_picture([renderer_of(mesh, arguments)], arguments.size, output)


if __name__ == "__main__":
    main()
