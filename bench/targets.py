"""The figures that tautline sets itself, each with where it is measured."""
from results import count, digits, plain_bytes, seconds, times

SIZES = ("1000", "3000", "10000", "30000", "100000")
MANIFOLDS = ("1e4", "1e5", "1e6", "1e7", "1e8")
CABLES = (("pillars/free", "among pillars"), ("pillars/short", "among pillars, often taut"),
          ("pillars/retracting", "among pillars, on a reel"), ("map/free", "on a map of 1,000 vertices"))
KERNELS = ("portable", "avx2", "avx512")
MAZE = "`make bench FILTER=maze`"


class Target:
    """A figure `value(results)` that must not be above (or, with at_least, below) `limit`."""

    def __init__(self, what, value, limit, text=seconds, command="", at_least=False):
        self.what, self.value, self.limit, self.text = what, value, limit, text
        self.command, self.at_least = command, at_least

    def met(self, results):
        value = self.value(results)
        return value >= self.limit if self.at_least else value <= self.limit

    def row(self, results):
        sign = "≥" if self.at_least else "≤"
        verdict = "met" if self.met(results) else "**missed**"
        return [self.what, self.text(self.value(results)), f"{sign} {self.text(self.limit)}", verdict, self.command]


def at(name, counter):
    return lambda results: results.value(name, counter)


def time_of(name):
    return lambda results: results.time(name)


def peer_ratio(name):
    """How many times the library's time the textbook peer takes on the same questions."""
    if name.endswith("/plan"):
        return lambda results: results.value(name, "h_augmented") / results.value(name, "same_questions")
    return lambda results: results.value(name, "h_augmented_dijkstra") / results.time(name)


def all_targets():
    targets = []
    for size in SIZES:
        name = f"triangulation/{size}"
        targets.append(Target(f"triangulation with locator, {int(size):,} vertices, against CGAL's",
                              lambda r, n=name: r.value(n, "build") / r.value(n, "cgal_build"), 1, times,
                              "`make bench FILTER=triangulation`"))
    for size, limit in (("1000", 4.5e-6), ("10000", 10e-6)):
        targets.append(Target(f"reduced visibility graph, {int(size):,} vertices, per vertex",
                              at(f"visibility_graph/{size}", "seconds_per_vertex"), limit, seconds,
                              "`make bench FILTER=visibility_graph`"))
    for name, text in (("corridor/1000", "corridor of 1,000 vertices"),
                       ("corridor/10000", "corridor of 10,000 vertices"),
                       ("tour/10000", "tour of a map of 10,000 vertices")):
        targets.append(Target(f"funnel per portal, {text}", at(f"funnel/{name}", "seconds_per_portal"), 6e-9,
                              seconds, "`make bench FILTER=funnel`"))
    targets.append(Target("MAZE: preparation", time_of("maze/prepare"), 3e-3, command=MAZE))
    questions = (("classes_up_to_length", "all classes within the tether, one goal", 25e-6),
                 ("shortest_classes/50", "50 shortest classes", 100e-6), ("plan", "plan, median", 30e-6))
    for name, text, limit in questions:
        targets.append(Target(f"MAZE: {text}", time_of(f"maze/{name}"), limit, command=MAZE))
    for name, text, _ in questions:
        targets.append(Target(f"MAZE: {text}; h-augmented peer", peer_ratio(f"maze/{name}"), 100, times, MAZE, True))
    for name, title in (("willow", "Willow"), ("intel", "Intel"), ("depot", "depot")):
        command = f"`make bench FILTER={name}`"
        targets.append(Target(f"{title}: preparation", time_of(f"{name}/prepare"), 1, command=command))
        targets.append(Target(f"{title}: plan, median", time_of(f"{name}/plan"), 5e-3, command=command))
        targets.append(Target(f"{title}: plan, worst", at(f"{name}/plan", "worst"), 0.1, command=command))
        targets.append(Target(f"{title}: plans out of budget", at(f"{name}/plan", "out_of_budget"), 0, digits, command))
    large = "growth/vertices/100000"
    command = f"`make bench FILTER={large}`"
    targets.append(Target("100,000 vertices, 5,000 obstacles: preparation", at(large, "prepare"), 10, command=command))
    targets.append(Target("100,000 vertices, 5,000 obstacles: plan, median", at(large, "plan"), 0.05, command=command))
    command = "`make bench FILTER=workspace/loops`"
    for limit in ("1200", "1300"):
        name = f"workspace/loops/{limit}"
        targets.append(Target(f"boundaries up to {limit} m, 4 anchors, 3 obstacles; Algorithm 2 as printed",
                              lambda r, n=name: r.value(n, "whole") / r.time(n), 100, times, command, True))
    targets.append(Target("boundaries up to 2 % longer than the shortest, 8 anchors, 20 obstacles",
                          time_of("workspace/length/2"), 1, command="`make bench FILTER=workspace/length`"))
    command = "`make bench FILTER=fleet`"
    for size, limit in (("1000", 1), ("10000", 60)):
        name = f"fleet/robots/{size}"
        targets.append(Target(f"fleet of {int(size):,} robots: layout checked, motion planned and played",
                              time_of(name), limit, command=command))
    return targets + manifold_targets() + cable_targets() + learning_targets()


def manifold_targets():
    targets = []
    for name, text, limit in (("60_thousand", "60 thousand vertices", 30), ("8_million", "8 million vertices", 100)):
        command = f"`make bench FILTER=manifold/{name}`"
        targets.append(Target(f"manifold, {text}; search over words as usually written",
                              at(f"manifold/{name}", "against_word_strings"), limit, times, command, True))
        targets.append(Target(f"manifold, {text}: vertices a second, of one sheet's cells a second",
                              at(f"manifold/{name}", "against_one_sheet"), 0.7, times, command, True))
        targets.append(Target(f"manifold, {text}: memory of a vertex",
                              at(f"manifold/{name}", "bytes_per_vertex"), 16, plain_bytes, command))
    for size in MANIFOLDS:
        command = f"`make bench FILTER=manifold/growth/{size}`"
        text = f"{int(float(size)):,} vertices in the open"
        targets.append(Target(f"manifold, {text}: vertices a second, of one sheet's cells a second",
                              at(f"manifold/growth/{size}", "against_one_sheet"), 0.7, times, command, True))
        targets.append(Target(f"manifold, {text}: memory of a vertex",
                              at(f"manifold/growth/{size}", "bytes_per_vertex"), 16, plain_bytes, command))
    targets.append(Target("manifold, 8 million vertices: two threads against one",
                          at("manifold/two_threads/wall", "two_threads"), 1.6, times,
                          "`make bench FILTER=manifold/two_threads`", True))
    return targets


def cable_targets():
    command = "`make bench FILTER=cable`"
    return [Target(f"cable of 200 nodes, {text}: times faster than real time",
                   at(f"cable/{name}", "real_time_factor"), 1000, times, command, True)
            for name, text in CABLES]


def learning_targets():
    command = "`make bench FILTER=learning`"
    return [Target("deep Q-network, batch of 32: a gradient step", time_of("learning/gradient/auto"), 300e-6,
                   command=command),
            Target("training of 300,000 steps (231 to 324 CPU s with Stable-Baselines3)",
                   time_of("learning/training"), 23.1, command=command),
            Target("environment of the contact-free planner, 12 nodes of cable or more, steps a second",
                   at("learning/environment", "steps_per_second"), 1.5e6, count, command, True)]
