#!/usr/bin/env python3
"""Writes the tables and pictures of docs/performance.md from the results of the benchmarks.

report.py RESULTS [PAGE]

RESULTS is a folder with Google Benchmark's JSON files. Each table stands in PAGE (default: docs/performance.md)
between `<!-- bench:NAME -->` and `<!-- /bench:NAME -->`; a table is left as it is when not all of its benchmarks
were run. Pictures go to the folder img beside the page. All tables that could be made are printed as well."""
import math
import pathlib
import platform
import re
import sys

from line_chart import LineChart
from results import Missing, Results, binary_bytes, count, digits, plain_bytes, seconds, table, times
from targets import CABLES, KERNELS, MANIFOLDS, SIZES, all_targets

SERIES_HOLES = ("10", "30", "100", "300", "1000", "3000")
TETHERS = ("2000", "3000", "4000", "5000", "6000", "7000", "8000")
MAPS = (("willow", "Willow Garage"), ("intel", "Intel Research Lab"), ("depot", "depot"))
CDT = (("maze", "MAZE"), ("mess", "MESS"))
LOOPS = ("1000", "1100", "1200", "1300")
ANCHORS = ("3", "4", "6", "8", "12", "16", "24")
OBSTACLES = ("3", "5", "10", "15", "20", "25", "30")
FLEETS = ("100", "316", "1000", "3162", "10000")
SHARES = ("1", "2", "3", "4", "5", "6", "8")


def processor():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def machine(results):
    for name in ("triangulation/1000", "maze/plan", "growth/tether/classes/8000"):
        results.entry(name)  # Only with a whole run.
    mhz = results.context["mhz_per_cpu"]
    return f"Machine: {processor()}, {mhz / 1000:.1f} GHz, one core; {results.context['date'][:10]}."


TARGETS_HEAD = ["figure", "measured", "target", "", "command"]


def targets(results, page):
    """The table of targets; what was not measured now keeps its row of the page."""
    old = {line.split(" | ")[0][2:]: line[2:-2].split(" | ") for line in page.splitlines() if line.startswith("| ")}
    rows = []
    for target in all_targets():
        try:
            rows.append(target.row(results))
        except Missing:
            rows.append(old.get(target.what, [target.what, "", "", "not measured", target.command]))
    return table(TARGETS_HEAD, rows)


def triangulation(results):
    rows = []
    for size in SIZES:
        name = f"triangulation/{size}"
        build, cgal = results.value(name, "build"), results.value(name, "cgal_build")
        find, cgal_find = results.value(name, "locate"), results.value(name, "cgal_locate")
        rows.append([count(results.value(name, "vertices")), seconds(build), seconds(cgal), times(build / cgal),
                     seconds(find / 1000), seconds(cgal_find / 1000), times((build + find) / (cgal + cgal_find))])
    head = ["vertices", "tautline: build with locator", "CGAL: build", "ratio", "tautline: locate", "CGAL: locate",
            "ratio with 1,000 locations"]
    return table(head, rows)


def visibility(results):
    rows = []
    for size in SIZES[:4]:
        name = f"visibility_graph/{size}"
        v = lambda counter: results.value(name, counter)
        rows.append([count(v("vertices")), count(v("corners")), count(v("edges")), seconds(v("seconds")),
                     seconds(v("seconds_per_vertex")), f"{v('bytes_per_vertex'):.0f} B"])
    return table(["vertices", "corners", "directed edges", "time", "per vertex", "memory per vertex"], rows)


def funnel(results):
    rows = []
    for name, text in (("corridor/1000", "corridor"), ("corridor/10000", "corridor"), ("corridor/100000", "corridor"),
                       ("tour/10000", "tour of 12 places, 10,000 vertices")):
        v = lambda counter: results.value(f"funnel/{name}", counter)
        rows.append([text, count(v("portals")), count(v("bends")), seconds(v("seconds_per_portal"))])
    return table(["sleeve", "portals", "points of the taut curve", "per portal"], rows)


def peer_time(results, name, counter):
    text = seconds(results.value(name, counter))
    return f"> {text}" if results.value(name, counter + "_gave_up") else text


PEERS = ("dijkstra", "a_star", "a_star_exact", "a_star_exact_bitangents")


def classes(results):
    rows = []
    for name, title in CDT:
        for question, text in (("classes_up_to_length", "all within the tether"), ("shortest_classes/5", "5 shortest"),
                               ("shortest_classes/50", "50 shortest")):
            bench = f"{name}/{question}"
            own = results.time(bench)
            peers = [results.value(bench, f"h_augmented_{peer}") for peer in PEERS]
            rows.append([f"{title}: {text}", digits(results.value(bench, "classes")), seconds(own),
                         seconds(results.value(bench, "repeated")), seconds(peers[0]), times(peers[0] / own), *map(seconds, peers[1:]), times(min(peers) / own)])
    head = ["question", "classes", "tautline", "again at once", "h-augmented peer", "ratio", "A*, straight line", "A*, exact rest",
            "and bitangents only", "ratio to the best"]
    return table(head, rows)


def plans(results):
    rows = []
    for name, title in CDT:
        bench = f"{name}/plan"
        own = results.time(bench)
        v = lambda counter: results.value(bench, counter)
        rows.append([title, seconds(results.time(f"{name}/prepare")), seconds(own), seconds(v("p99")),
                     seconds(v("worst")), peer_time(results, bench, "h_augmented"),
                     times(v("h_augmented") / v("same_questions")),
                     seconds(v("h_augmented_search")), peer_time(results, bench, "grid"), seconds(v("grid_search"))])
    head = ["map", "preparation", "plan: median", "p99", "worst", "h-augmented peer", "ratio", "of that, search",
            "grid peer", "of that, search"]
    return table(head, rows)


def real_maps(results):
    rows = []
    for name, title in MAPS:
        v = lambda counter: results.value(f"{name}/plan", counter)
        prepared = lambda counter: results.value(f"{name}/prepare", counter)
        rows.append([title, count(prepared("vertices")), count(prepared("islands")), count(prepared("edges")),
                     seconds(results.time(f"{name}/prepare")), count(v("queries")), seconds(results.time(f"{name}/plan")),
                     seconds(v("p99")), seconds(v("worst")), count(v("out_of_budget"))])
    head = ["map", "vertices", "islands", "directed edges", "preparation", "questions", "median", "p99", "worst",
            "out of budget"]
    return table(head, rows)


def real_peers(results):
    rows = []
    for name, title in MAPS:
        bench = f"{name}/plan_with_peer"
        v = lambda counter: results.value(bench, counter)
        own, peer = results.time(bench), v("h_augmented")
        bound = "> " if v("h_augmented_gave_up") else ""
        rows.append([title, seconds(own), bound + seconds(peer), bound + times(peer / own),
                     count(v("h_augmented_states")), f"{v('h_augmented_gave_up'):.0f} of {v('queries'):.0f}"])
    return table(["map", "tautline", "h-augmented peer", "ratio", "its states", "gave up"], rows)


def growth_rows(results, names):
    rows = []
    for name in names:
        v = lambda counter: results.value(name, counter)
        rows.append([count(v("vertices")), count(v("holes")), count(v("edges")), seconds(v("prepare")),
                     binary_bytes(v("kept_bytes")), binary_bytes(v("peak_bytes")), seconds(v("plan")),
                     seconds(v("plan_worst")), count(v("out_of_budget"))])
    head = ["vertices", "holes", "directed edges", "preparation", "memory kept", "peak", "plan: median", "worst",
            "out of budget"]
    return table(head, rows)


def growth_vertices(results):
    return growth_rows(results, [f"growth/vertices/{size}" for size in SIZES])


def growth_holes(results):
    return growth_rows(results, [f"growth/holes/{size}" for size in SERIES_HOLES])


def growth_tether(results):
    rows = []
    for group in range(8):
        v = lambda counter: results.value("growth/tether/plan", f"group{group}_{counter}")
        rows.append([f"{v('tether'):.0f} m", seconds(v("median"))])
    return table(["tether (middle of an eighth of the questions)", "plan: median"], rows)


def growth_classes(results):
    rows = []
    for length in TETHERS:
        name = f"growth/tether/classes/{length}"
        v = lambda counter: results.value(name, counter)
        own = results.time(name)
        bound = "> " if v("h_augmented_gave_up") else ""
        rows.append([count(v("length")), count(v("classes")), seconds(own), seconds(own / max(1, v("classes"))),
                     binary_bytes(v("kept_bytes")), bound + seconds(v("h_augmented")), bound + times(v("h_augmented") / own)])
    return table(["tether", "classes", "tautline", "per class", "memory of the answer", "h-augmented peer", "ratio"], rows)


def workspace_loops(results):
    rows = []
    for limit in LOOPS:
        name = f"workspace/loops/{limit}"
        v = lambda counter: results.value(name, counter)
        own = results.time(name)
        bound = "> " if v("gave_up") else ""
        peers = [text for counter in ("whole", "partial")
                 for text in (bound + seconds(v(counter)), bound + times(v(counter) / own))]
        rows.append([f"{v('length'):.0f} m", digits(v("boundaries")), count(v("classes")), count(v("possible")),
                     seconds(own), *peers])
    return table(["up to", "boundaries", "classes of the peer", "combinations", "tautline", "Algorithm 2 as printed", "ratio",
                  "with partial products", "ratio"], rows)


def workspace_rows(results, names, head, first):
    rows = []
    for name in names:
        v = lambda counter: results.value(name, counter)
        own = results.time(name)
        rows.append([first(v), f"{v('length'):.0f} m", count(v("boundaries")), seconds(own),
                     seconds(own / v("boundaries"))])
    return table([head, "up to", "boundaries", "time", "per boundary"], rows)


def workspace_anchors(results):
    return workspace_rows(results, [f"workspace/anchors/{n}" for n in ANCHORS], "anchors", lambda v: count(v("anchors")))


def workspace_obstacles(results):
    return workspace_rows(results, [f"workspace/obstacles/{n}" for n in OBSTACLES], "obstacles",
                          lambda v: count(v("obstacles")))


def workspace_length(results):
    return workspace_rows(results, [f"workspace/length/{n}" for n in SHARES], "longer than the shortest by up to",
                          lambda v: f"{100 * v('share'):.0f} %")


FLEET_STAGES = ("prepare", "read", "check", "play")


def fleet(results):
    rows = []
    for size in FLEETS:
        name = f"fleet/robots/{size}"
        v = lambda counter: results.value(name, counter)
        whole = sum(v(stage) for stage in FLEET_STAGES)
        rows.append([count(v("robots")), count(v("crossings")), count(v("detours")),
                     *(seconds(v(stage)) for stage in FLEET_STAGES), seconds(whole), seconds(v("measure"))])
    return table(["robots", "crossings", "detours", "ground", "cable lines read", "layout checked", "motion planned and played",
                  "all together", "played once more, cables measured"], rows)


def fleet_peer(results):
    rows = []
    for size in FLEETS:
        name = f"fleet/robots/{size}"
        v = lambda counter: results.value(name, counter)
        rows.append([count(v("robots")), seconds(v("plan")), seconds(v("printed")), times(v("printed") / v("plan")),
                     count(v("detours")), count(v("printed_detours")), binary_bytes(v("kept_bytes")),
                     binary_bytes(v("peak_bytes")), f"{v('bytes_per_crossing'):.0f} B"])
    return table(["robots", "tautline: motion planned, not played", "as printed", "ratio", "detours", "as printed", "memory of the plan",
                  "peak", "per crossing"], rows)


def exponent(points):
    """The slope of the line through (x, y) points that fits their logarithms best."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x, mean_y = (sum(p[k] for p in logs) / len(logs) for k in (0, 1))
    spread = sum((x - mean_x) ** 2 for x, _ in logs)
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / spread if spread else 0.0


def fleet_series(results):
    """The lines of the picture of growth, by what they show."""
    points = {}
    for size in FLEETS:
        v = lambda counter: results.value(f"fleet/robots/{size}", counter)
        for what, value in (("ground, cable lines, check, motion planned and played", sum(v(stage) for stage in FLEET_STAGES)),
                            ("motion planned, not played", v("plan")), ("as printed", v("printed"))):
            points.setdefault(what, []).append((v("robots"), value))
    return points


def fleet_growth(results):
    return "\n".join(f"- {what}: n^{exponent(points):.2f}" for what, points in fleet_series(results).items())


def manifold_rows(results, names):
    rows = []
    for name in names:
        v = lambda counter: results.value(f"manifold/{name}", counter)
        rows.append([count(v("vertices")), seconds(v("seconds")), seconds(v("seconds") / v("vertices")),
                     seconds(1 / v("cells_per_second")), times(v("against_one_sheet")), plain_bytes(v("bytes_per_vertex"))])
    return rows


MANIFOLD_HEAD = ["vertices", "time", "per vertex", "one sheet: per cell", "ratio", "memory of a vertex"]


def manifold(results):
    rows = manifold_rows(results, ("60_thousand", "8_million"))
    for row, name in zip(rows, ("60_thousand", "8_million")):
        v = lambda counter: results.value(f"manifold/{name}", counter)
        row += [seconds(v("word_strings")), times(v("against_word_strings"))]
    return table([*MANIFOLD_HEAD, "search over words as usually written", "ratio"], rows)


def manifold_growth(results):
    names = [f"growth/{size}" for size in MANIFOLDS]
    points = [(results.value(f"manifold/{n}", "vertices"), results.value(f"manifold/{n}", "seconds")) for n in names]
    rows = table(MANIFOLD_HEAD, manifold_rows(results, names))
    return f"{rows}\n\nThe exponent of growth, fitted to all of them: n^{exponent(points):.2f}."


def manifold_threads(results):
    wall, schedule = "manifold/two_threads/wall", "manifold/two_threads/schedule"
    return table(["8 million vertices", "one thread", "two threads", "ratio", "if none waits for a processor"],
                 [["quickest of 15", seconds(results.value(wall, "one")), seconds(results.value(wall, "two")),
                   times(results.value(wall, "two_threads")), times(results.value(schedule, "two_threads"))]])


def cable(results):
    rows = []
    for name, text in CABLES:
        v = lambda counter: results.value(f"cable/{name}", counter)
        rows.append([text, count(v("nodes")), count(v("contacts")), times(v("real_time_factor")), ""])
    for sweeps in (1, 20):
        v = lambda counter: results.value(f"cable/pillars/plain_rope/{sweeps}", counter)
        what = f"plain rope among pillars, {sweeps} sweep{'s' if sweeps > 1 else ''} a step"
        rows.append([what, "", "", times(v("real_time_factor")), f"{100 * v('steps_through_obstacles'):.0f} %"])
    return table(["cable", "nodes", "contacts", "times faster than real time", "steps with links in obstacles"], rows)


def learning(results):
    rows = []
    for kernels in KERNELS:
        try:
            rows.append([f"gradient step, `{kernels}`", seconds(results.time(f"learning/gradient/{kernels}"))])
        except Missing:
            pass  # This processor lacks them.
    training = "learning/training"
    rows.append([f"training of 300,000 steps with {count(results.value(training, 'gradient_steps'))} gradient steps, `auto`",
                 seconds(results.time(training))])
    environment = "learning/environment"
    rows.append([f"environment with {digits(results.value(environment, 'nodes'))} nodes of cable, steps a second",
                 count(results.value(environment, "steps_per_second"))])
    return table(["what", "one core"], rows)


def chart_manifold(results):
    millions = lambda value: f"{digits(value / 1e6)} million"
    chart = LineChart("The manifold on a grid", "vertices", "processor time", millions, seconds)
    names = [f"manifold/growth/{size}" for size in MANIFOLDS]
    chart.add("in the open", [(results.value(n, "vertices"), results.value(n, "seconds")) for n in names])
    small = [f"manifold/{name}" for name in ("60_thousand", "8_million")]
    chart.add("among 9 islands", [(results.value(n, "vertices"), results.value(n, "seconds")) for n in small])
    chart.add("search over words as usually written",
              [(results.value(n, "vertices"), results.value(n, "word_strings")) for n in small])
    return chart


def chart_fleet(results):
    chart = LineChart("Fleets: time over robots", "robots", "processor time", count, seconds)
    for what, points in fleet_series(results).items():
        chart.add(f"{what}: n^{exponent(points):.2f}", points)
    return chart


def chart_triangulation(results):
    chart = LineChart("Constrained triangulation", "vertices", "time to build", count, seconds)
    for name, counter in (("tautline, with locator", "build"), ("CGAL", "cgal_build")):
        chart.add(name, [(results.value(f"triangulation/{s}", "vertices"), results.value(f"triangulation/{s}", counter))
                         for s in SIZES])
    return chart


def chart_growth(results, title, x_label, x_counter, names):
    chart = LineChart(title, x_label, "processor time", count, seconds)
    for name, counter in (("preparation", "prepare"), ("plan, median", "plan")):
        chart.add(name, [(results.value(n, x_counter), results.value(n, counter)) for n in names])
    return chart


def chart_vertices(results):
    return chart_growth(results, "Synthetic maps, twenty vertices an obstacle", "vertices", "vertices",
                        [f"growth/vertices/{size}" for size in SIZES])


def chart_holes(results):
    return chart_growth(results, "Synthetic maps of 20,000 vertices", "obstacles", "holes",
                        [f"growth/holes/{size}" for size in SERIES_HOLES])


def chart_classes(results):
    chart = LineChart("All classes within the tether, MAZE", "tether", "processor time", count, seconds)
    names = [f"growth/tether/classes/{length}" for length in TETHERS]
    chart.add("tautline", [(results.value(n, "length"), results.time(n)) for n in names])
    # Where the peer gave up there is a bound, not a time.
    chart.add("h-augmented graph", [(results.value(n, "length"), results.value(n, "h_augmented")) for n in names
                                    if not results.value(n, "h_augmented_gave_up")])
    return chart


def chart_workspace(results):
    chart = LineChart("All valid boundaries of a cable workspace", "boundaries found", "processor time", count, seconds)
    for name, series in (("more length, 8 anchors, 20 obstacles", [f"workspace/length/{n}" for n in SHARES]),
                         ("more obstacles, 8 anchors, 2 % length", [f"workspace/obstacles/{n}" for n in OBSTACLES]),
                         ("more anchors, 10 obstacles, 5 % length", [f"workspace/anchors/{n}" for n in ANCHORS])):
        chart.add(name, [(results.value(n, "boundaries"), results.time(n)) for n in series])
    return chart


def chart_workspace_growth(results):
    chart = LineChart("Cable workspaces: time over anchors and over obstacles", "anchors or obstacles", "processor time",
                      count, seconds)
    for name, counter, series in (
            ("anchors, 10 obstacles, up to 5 % longer than the shortest", "anchors",
             [f"workspace/anchors/{n}" for n in ANCHORS]),
            ("obstacles, 8 anchors, up to 2 % longer", "obstacles", [f"workspace/obstacles/{n}" for n in OBSTACLES])):
        chart.add(name, [(results.value(n, counter), results.time(n)) for n in series])
    return chart


def chart_workspace_loops(results):
    chart = LineChart("Four anchors, three obstacles", "combinations of classes", "processor time", count, seconds)
    names = [f"workspace/loops/{limit}" for limit in LOOPS]
    chart.add("tautline", [(results.value(n, "possible"), results.time(n)) for n in names])
    for name, counter in (("Algorithm 2 as printed", "whole"), ("with partial products", "partial")):
        chart.add(name, [(results.value(n, "possible"), results.value(n, counter)) for n in names
                         if not results.value(n, "gave_up")])
    return chart


TABLES = {"machine": machine, "triangulation": triangulation, "visibility": visibility,
          "funnel": funnel, "classes": classes, "plans": plans, "real_maps": real_maps, "real_peers": real_peers,
          "growth_vertices": growth_vertices, "growth_holes": growth_holes, "growth_tether": growth_tether,
          "growth_classes": growth_classes, "workspace_loops": workspace_loops, "workspace_anchors": workspace_anchors,
          "workspace_obstacles": workspace_obstacles, "workspace_length": workspace_length, "fleet": fleet,
          "fleet_peer": fleet_peer, "fleet_growth": fleet_growth,
          "manifold": manifold, "manifold_growth": manifold_growth, "manifold_threads": manifold_threads, "cable": cable, "learning": learning}
CHARTS = {"performance_triangulation": chart_triangulation, "performance_vertices": chart_vertices,
          "performance_holes": chart_holes, "performance_classes": chart_classes,
          "performance_workspace": chart_workspace, "performance_workspace_growth": chart_workspace_growth,
          "performance_workspace_loops": chart_workspace_loops, "performance_fleet": chart_fleet,
          "performance_manifold": chart_manifold}


def with_table(page, name, text):
    """The page with what stands between the markers of a table replaced."""
    pattern = re.compile(rf"(<!-- bench:{name} -->\n).*?(<!-- /bench:{name} -->)", re.S)
    if not pattern.search(page):
        raise SystemExit(f"the page has no place for the table {name}: <!-- bench:{name} --><!-- /bench:{name} -->")
    return pattern.sub(lambda match: f"{match[1]}{text}\n{match[2]}", page)


def made(makers, results):
    """What the makers can make of these results, by name."""
    found = {}
    for name, make in makers.items():
        try:
            found[name] = make(results)
        except Missing:
            continue
    return found


def print_verdicts(results):
    """Each target that was measured; with a filter, the table of all cannot be made."""
    for target in all_targets():
        try:
            print("  ".join(target.row(results)[:4]))
        except Missing:
            continue


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    results = Results(sys.argv[1])
    path = pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else "docs/performance.md")
    page = path.read_text()
    for name, text in made(TABLES, results).items():
        print(f"{name}\n{text}\n")
        page = with_table(page, name, text)
    page = with_table(page, "targets", targets(results, page))
    for name, chart in made(CHARTS, results).items():
        (path.parent / "img" / f"{name}.svg").write_text(chart.svg())
    path.write_text(page)
    print_verdicts(results)


if __name__ == "__main__":
    main()
