#!/usr/bin/python3
# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws the pictures of the manual.

  draw_figures.py FOLDER OUTPUT [FIGURE ...]

FOLDER holds what manual_figures wrote. OUTPUT receives, for each figure (or only those named), its
pictures NAME_0.png, NAME_1.png ... or NAME.svg, and NAME.html, which shows them in the manual.
Needs VTK for Python and a display; without one, it starts itself again under xvfb-run.
"""

import html
import json
import pathlib
import sys

sys.path.append(str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))

import render  # noqa: E402
import vtk  # noqa: E402

import charts  # noqa: E402

# Camera, by mesh: up, azimuth, elevation. Others are seen as render.py sees them.
VIEWS = {
    "camel from behind": ("y", 150, 15),
    "elephant": ("y", 150, 15),
    "elephant in its frame": ("z", 30, 20),
    "eight": ("y", 60, 35),
    "man": ("z", 285, 5),
}
USUAL_VIEW = ("y", 30, 20)

# Pictures in a row, and their size in pixels.
LAYOUTS = {
    "face_graph": (2, (900, 500)),
    "contexts": (2, (700, 560)),
    "samples": (2, (700, 560)),
    "line": (2, (700, 560)),
    "seeds": (2, (700, 560)),
    "equipment": (2, (700, 560)),
    "clusterings": (3, (480, 400)),
    "features": (3, (480, 400)),
    # A mesh that is long and low
    "tree": (4, (480, 290)),
    "salience_threshold": (4, (480, 290)),
    "number_of_segments": (4, (480, 290)),
}
USUAL_LAYOUT = (4, (480, 400))


def colored(data, colors):
    array = vtk.vtkUnsignedCharArray()
    array.SetNumberOfComponents(3)
    for color in colors:
        array.InsertNextTuple3(*color)
    data.GetCellData().SetScalars(array)


def plain_actor(source):
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtk.vtkActor()
    actor.SetMapper(mapper)
    return actor


def tubes_actor(tubes, radius):
    points, cells = vtk.vtkPoints(), vtk.vtkCellArray()
    for tube in tubes:
        cells.InsertNextCell(2)
        cells.InsertCellPoint(points.InsertNextPoint(tube["from"]))
        cells.InsertCellPoint(points.InsertNextPoint(tube["to"]))
    lines = vtk.vtkPolyData()
    lines.SetPoints(points)
    lines.SetLines(cells)
    colored(lines, [tube["color"] for tube in tubes])
    filter_ = vtk.vtkTubeFilter()
    filter_.SetInputData(lines)
    filter_.SetRadius(radius)
    filter_.SetNumberOfSides(6)
    filter_.CappingOn()
    return plain_actor(filter_)


def ball_actor(ball, radius):
    sphere = vtk.vtkSphereSource()
    sphere.SetCenter(ball["center"])
    sphere.SetRadius(radius)
    sphere.SetThetaResolution(24)
    sphere.SetPhiResolution(24)
    actor = plain_actor(sphere)
    actor.GetProperty().SetColor(*(c / 255 for c in ball["color"]))
    return actor


def extra_actors(picture, mesh):
    for ball in picture.get("balls", []):
        yield ball_actor(ball, 0.018 * mesh.GetLength())
    by_width = {}
    for tube in picture.get("tubes", []):
        by_width.setdefault(round(tube["width"], 1), []).append(tube)
    for width, tubes in by_width.items():
        yield tubes_actor(tubes, 0.0013 * width * mesh.GetLength())


def draw_picture(picture, folder, size, output):
    mesh = render.read_mesh(str(folder / (picture["name"] + ".ply")))
    renderer = render.blank_renderer()
    renderer.AddActor(render.actor_of(mesh, False))
    for actor in extra_actors(picture, mesh):
        renderer.AddActor(actor)
    renderer.AutomaticLightCreationOff()
    render.add_lights(renderer)
    render.set_camera(renderer, mesh, *VIEWS.get(picture["mesh"], USUAL_VIEW))
    render.fill_view(renderer, mesh, size[0] / size[1])
    render.write_picture([renderer], size, output)


def fragment(columns, pictures, pages={}):
    """The HTML of a figure: pairs of a file and its caption. Some files have a page to link to."""
    lines = ['<div class="pictures columns-%d">' % columns]
    for file, caption in pictures:
        text = html.escape(caption)
        image = '<img src="pictures/%s" alt="%s"/>' % (file, text)
        if file in pages:
            image = '<a href="%s">%s</a>' % (pages[file], image)
        lines.append('<figure>%s<figcaption>%s</figcaption></figure>' % (image, text))
    return "\n".join(lines + ["</div>", ""])


def draw_figure(name, pictures, folder, output):
    columns, size = LAYOUTS.get(name, USUAL_LAYOUT)
    for picture in pictures:
        draw_picture(picture, folder, size, output / (picture["name"] + ".png"))
    files = [(picture["name"] + ".png", picture["caption"]) for picture in pictures]
    pages = {}
    for picture in pictures:
        page = "pages/%s.html" % picture["mesh"]
        if name == "gallery" and (output.parent / page).exists():
            pages[picture["name"] + ".png"] = page
    (output / (name + ".html")).write_text(fragment(columns, files, pages))


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    render.ensure_display()
    folder, output = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    wanted = sys.argv[3:]
    output.mkdir(parents=True, exist_ok=True)
    figures = json.loads((folder / "figures.json").read_text())
    for name, pictures in figures["figures"].items():
        if not wanted or name in wanted:
            draw_figure(name, pictures, folder, output)
    for name, draw in charts.CHARTS.items():
        if not wanted or name in wanted:
            caption, svg = draw(figures["charts"])
            (output / (name + ".svg")).write_text(svg)
            (output / (name + ".html")).write_text(fragment(1, [(name + ".svg", caption)]))


if __name__ == "__main__":
    main()
