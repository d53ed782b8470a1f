# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The charts of the manual, as SVG."""

import html

WIDTH, HEIGHT = 640, 396
LEFT, RIGHT, TOP, BOTTOM = 60, 20, 20, 76


class Svg:
    """A chart with an area for x and y in given ranges."""

    def __init__(self, x_range, y_range):
        self.x_range, self.y_range = x_range, y_range
        self.items = []

    def x(self, value):
        low, high = self.x_range
        return LEFT + (value - low) / (high - low) * (WIDTH - LEFT - RIGHT)

    def y(self, value):
        low, high = self.y_range
        return HEIGHT - BOTTOM - (value - low) / (high - low) * (HEIGHT - TOP - BOTTOM)

    def polyline(self, points, color, width=2, dashes=""):
        path = " ".join("%.1f,%.1f" % (self.x(x), self.y(y)) for x, y in points)
        self.items.append('<polyline points="%s" fill="none" stroke="%s" stroke-width="%g"%s/>'
                          % (path, color, width,
                             ' stroke-dasharray="%s"' % dashes if dashes else ""))

    def text(self, x, y, text, anchor="start", color="#222222"):
        """Text with a white rim, so that it can be read on lines."""
        self.items.append('<text x="%.1f" y="%.1f" text-anchor="%s" fill="%s" font-size="15" '
                          'stroke="white" stroke-width="5" paint-order="stroke">%s</text>'
                          % (x, y, anchor, color, html.escape(text)))

    def square(self, x, y, color, side=14):
        self.items.append('<rect x="%.1f" y="%.1f" width="%d" height="%d" fill="%s" '
                          'stroke="#444444" stroke-width="0.5"/>'
                          % (self.x(x) - side / 2, self.y(y), side, side, color))

    def ball(self, x, y, color):
        self.items.append('<circle cx="%.1f" cy="%.1f" r="6" fill="%s"/>'
                          % (self.x(x), self.y(y), color))

    def y_axis(self, title, step):
        low, high = self.y_range
        value = low
        while value < high + step / 2:
            self.polyline([(self.x_range[0], value), (self.x_range[1], value)], "#dddddd", 1)
            self.text(LEFT - 8, self.y(value) + 5, "%.1f" % value, "end")
            value += step
        self.items.append('<text x="16" y="%.1f" text-anchor="middle" fill="#222222" '
                          'font-size="15" transform="rotate(-90 16 %.1f)">%s</text>'
                          % ((TOP + HEIGHT - BOTTOM) / 2, (TOP + HEIGHT - BOTTOM) / 2,
                             html.escape(title)))

    def x_axis(self, title, values):
        for value in values:
            self.text(self.x(value), HEIGHT - BOTTOM + 18, "%.1f" % value, "middle")
        self.text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - BOTTOM + 40, title, "middle")

    def __str__(self):
        return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d" '
                'height="%d" font-family="sans-serif">\n'
                '<rect width="100%%" height="100%%" fill="white"/>\n%s\n</svg>\n'
                % (WIDTH, HEIGHT, WIDTH, HEIGHT, "\n".join(self.items)))


CURVES = (("size", 1, "#2a9d3a"), ("cut strength", 2, "#2a5fc8"),
          ("protrusiveness", 3, "#e08a10"), ("salience", 4, "#c81e1e"))


def thinned(steps):
    """At most some hundred steps, the best one among them."""
    every = max(1, len(steps) // 800)
    best = max(range(len(steps)), key=lambda i: steps[i][4])
    return [step for i, step in enumerate(steps) if i % every == 0 or i == best]


def line_search(charts):
    data = charts["line_search"]
    steps = thinned(data["good"])
    svg = Svg((0, 1), (0, 1))
    svg.y_axis("salience and its factors", 0.2)
    svg.polyline([(0, data["threshold"]), (1, data["threshold"])], "#666666", 1.5, "6 4")
    n = data["number_of_faces"]
    for i, (name, column, color) in enumerate(CURVES):
        points = [(step[0] / n, max(0, step[column])) for step in steps]
        svg.polyline(points, color, 3 if column == 4 else 1.5)
        svg.text(LEFT + 145 * i, HEIGHT - 8, "— " + name, color=color)
    svg.text(svg.x(0.5), svg.y(data["threshold"]) - 6, "threshold", "middle", "#666666")
    best = max(steps, key=lambda step: step[4])
    svg.ball(best[0] / n, best[4], "#c81e1e")
    svg.text(svg.x(best[0] / n), svg.y(best[4]) - 14, "best cut", "middle", "#c81e1e")
    svg.x_axis("fraction of the faces in Q", [0, 0.2, 0.4, 0.6, 0.8, 1])
    return ("salience of the cut after each step of the line search, and its three factors; "
            "negative values are drawn as 0", str(svg))


def tree_of_cuts(charts):
    data = charts["tree"]
    nodes = data["nodes"]
    place = {}

    def put(i):
        if "children" in nodes[i]:
            place[i] = sum(put(child) for child in nodes[i]["children"]) / 2
        else:
            place[i] = sum(1 for j in place if "children" not in nodes[j])
        return place[i]

    put(0)
    leaves = sum(1 for node in nodes if "children" not in node)
    svg = Svg((-0.5, leaves - 0.5), (0, 1))
    svg.y_axis("salience of the cut", 0.2)
    for i, node in enumerate(nodes):
        if "children" not in node:
            svg.square(place[i], 0, "#%02x%02x%02x" % tuple(node["color"]))
            continue
        color = "#222222" if node["salience"] >= data["threshold"] else "#aaaaaa"
        for child in node["children"]:
            bottom = nodes[child]["salience"] if "children" in nodes[child] else 0
            svg.polyline([(place[i], node["salience"]), (place[child], node["salience"]),
                          (place[child], bottom)], color)
    svg.polyline([(-0.5, data["threshold"]), (leaves - 0.5, data["threshold"])], "#c81e1e", 1.5,
                 "6 4")
    svg.text(svg.x(leaves - 0.5) - 4, svg.y(data["threshold"]) - 6, "threshold", "end", "#c81e1e")
    svg.x_axis("regions", [])
    return ("tree of cuts: the higher a cut, the more salient; those below the threshold are grey; "
            "the squares have the colors of the regions above", str(svg))


CHARTS = {"line_search": line_search, "tree_of_cuts": tree_of_cuts}
