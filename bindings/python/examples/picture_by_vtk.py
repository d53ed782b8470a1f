#!/usr/bin/env python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A picture of a segmented mesh with the boundaries between segments, by VTK without a window.

    picture_by_vtk.py elephant.off -o elephant.png

Needs VTK and, where there is no display, xvfb-run: Debian's packages python3-vtk9, xvfb and xauth.
"""

import argparse
import os
import shutil
import sys

import numpy as np
import vtk
from spectral_segmentation import boundary_edges, read, segment, segment_colors
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

DIRECTIONS = {"x": (0, 1, 0), "y": (0, 0, 1), "z": (1, 0, 0)} # toward the viewer, by what is up


def cells_of(indices):
    """Triangles or edges for VTK, from an array with a row for each of them."""
    cells = vtk.vtkCellArray()
    cells.SetData(indices.shape[1], numpy_to_vtkIdTypeArray(np.int64(indices).ravel(), deep=True))
    return cells


def actor_of(data):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputData(data)
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetInterpolationToFlat()
    return actor


def actors_of(mesh, labels):
    """Returns the triangles in the colors of their segments, and lines between segments."""
    points = vtk.vtkPoints()
    points.SetData(numpy_to_vtk(mesh.points, deep=True))
    surface, lines = vtk.vtkPolyData(), vtk.vtkPolyData()
    surface.SetPoints(points)
    surface.SetPolys(cells_of(mesh.triangles))
    colors = segment_colors(mesh.triangles, labels)[labels]
    surface.GetCellData().SetScalars(numpy_to_vtk(colors, deep=True))
    lines.SetPoints(points)
    edges, _ = boundary_edges(mesh.triangles, labels)
    lines.SetLines(cells_of(edges))
    on_surface = actor_of(lines)
    on_surface.GetProperty().SetColor(0.1, 0.1, 0.1)
    on_surface.GetProperty().LightingOff()
    on_surface.GetProperty().SetLineWidth(3)
    # In front of the triangles that they are edges of
    on_surface.GetMapper().SetResolveCoincidentTopologyToPolygonOffset()
    on_surface.GetMapper().SetRelativeCoincidentTopologyLineOffsetParameters(-4, -4)
    return actor_of(surface), on_surface


def fill_view(renderer, points, size):
    renderer.ResetCamera()
    camera = renderer.GetActiveCamera()
    camera.ParallelProjectionOn()
    camera.OrthogonalizeViewUp()
    upward = np.array(camera.GetViewUp())
    rightward = np.cross(camera.GetDirectionOfProjection(), upward)
    width, height = np.abs((points - camera.GetFocalPoint()) @ np.transpose([rightward, upward])
                           ).max(axis=0)
    camera.SetParallelScale(1.05 * max(height, width * size[1] / size[0]))


def write_picture(actors, points, up, size, path):
    renderer = vtk.vtkRenderer()
    renderer.SetBackground(1, 1, 1)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    camera.SetPosition(*DIRECTIONS[up])
    camera.SetViewUp(*np.eye(3)["xyz".index(up)])
    camera.Azimuth(30)
    camera.Elevation(20)
    fill_view(renderer, points, size)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    window.Render()
    picture = vtk.vtkWindowToImageFilter()
    picture.SetInput(window)
    picture.ReadFrontBufferOff()
    writer = vtk.vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputConnection(picture.GetOutputPort())
    writer.Write()
    if writer.GetErrorCode() != 0:
        sys.exit("cannot write " + path)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("mesh", help="OFF, OBJ, PLY or STL")
    parser.add_argument("-o", "--output", default="picture.png", help="[%(default)s]")
    parser.add_argument("--segments", type=int, metavar="N", help="the number of segments")
    parser.add_argument("--up", choices="xyz", default="y", help="the axis upwards [%(default)s]")
    parser.add_argument("--size", type=int, nargs=2, default=(1000, 800), metavar=("W", "H"),
                        help="in pixels [1000 800]")
    arguments = parser.parse_args()
    if sys.platform == "linux" and "DISPLAY" not in os.environ and shutil.which("xvfb-run"):
        os.execvp("xvfb-run", ["xvfb-run", "-a", sys.executable, *sys.argv])

    mesh = read(arguments.mesh)
    labels = segment(mesh, number_of_segments=arguments.segments)
    write_picture(actors_of(mesh, labels), mesh.points, arguments.up, arguments.size,
                  arguments.output)


if __name__ == "__main__":
    main()
