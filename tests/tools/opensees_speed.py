#!/usr/bin/env python3
"""Times `houscaper solve`, OpenSees and PyNite on the same frames, in one run, on one core.

    opensees_speed.py [--houscaper PROGRAM] [--repeat 5] [--pynite-nodes 600] FRAME.json ...

Printed are milliseconds of process CPU time: of the others the least of the repeats, of ours the mean over many more (what
further solves of one process cost), which flatters them. "build": the model and its loads; "solve": all load cases on one factor where the program can do so; "results":
end forces of all members, node by node and member by member as the Python interface gives them. Ratios are their sum over ours,
and without the results, which are Python's and not the solver's.

OpenSees is run with each of its sparse and banded solvers and the best is taken. PyNite (no shear, its own member axes: the
work is the same) only on frames of at most --pynite-nodes nodes. Frames to time: those that
`HOUSCAPER_WRITE_FRAMES=folder cargo bench --bench analysis` writes. Exit code 3: openseespy is not there.
Needs openseespy, numpy and, for the third column, PyNiteFEA; see opensees_compare.py.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import time

for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(name, "1")

from opensees_compare import HERE, Frame, build, np, ops  # noqa: E402  (exits with 3 when openseespy is missing)

SYSTEMS = ["UmfPack", "SparseSYM", "SparseGeneral", "BandSPD", "ProfileSPD"]


def opensees(frame, system):
    """Seconds of build, solve and results."""
    started = time.process_time()
    build(frame, [])
    cases = frame.data["cases"]
    for c, case in enumerate(cases):
        # Every case acts in its own step, so that one factor serves them all.
        ops.timeSeries("Rectangular", c + 1, c + 0.5, c + 1.5)
        ops.pattern("Plain", c + 1, c + 1)
        for m, _, q in frame.loads(case):
            ops.eleLoad("-ele", m + 1, "-type", "-beamUniform", q[1], q[2], q[0])
    ops.constraints("Plain")
    ops.numberer("RCM")
    ops.system(system)
    ops.algorithm("Linear", "-factorOnce")
    ops.integrator("LoadControl", 1.0)
    ops.analysis("Static")
    built = time.process_time()
    spent = [built - started, 0.0, 0.0]
    for _ in cases:
        begin = time.process_time()
        if ops.analyze(1) != 0:
            raise RuntimeError(f"{system} failed")
        middle = time.process_time()
        for m in range(len(frame.members)):
            ops.eleResponse(m + 1, "localForce")
        spent[1] += middle - begin
        spent[2] += time.process_time() - middle
    ops.wipe()
    return spent


def pynite(frame):
    """Seconds of build, solve and results."""
    from Pynite import FEModel3D

    started = time.process_time()
    model = FEModel3D()
    for n, place in enumerate(frame.nodes.tolist()):
        model.add_node(f"N{n}", *place)
    for k, m in enumerate(frame.data["materials"]):
        model.add_material(f"T{k}", m["E"], m["G"], 0.3, m.get("rho", 0.0))
    for k, s in enumerate(frame.data["sections"]):
        model.add_section(f"S{k}", s["A"], s["Iy"], s["Iz"], s["J"])
    for m, member in enumerate(frame.members):
        i, j = member["n"]
        model.add_member(f"M{m}", f"N{i}", f"N{j}", f"T{member['mat']}", f"S{member['sec']}")
    for n in np.nonzero(frame.fixed.any(axis=1))[0]:
        model.def_support(f"N{n}", *(bool(f) for f in frame.fixed[n]))
    for c, case in enumerate(frame.data["cases"]):
        for m, _, q in frame.loads(case):
            for axis, value in zip(("Fx", "Fy", "Fz"), q):
                if value:
                    model.add_member_dist_load(f"M{m}", axis, value, value, case=f"C{c}")
        model.add_load_combo(f"C{c}", {f"C{c}": 1.0})
    built = time.process_time()
    model.analyze_linear(check_stability=False)
    solved = time.process_time()
    for c in range(len(frame.data["cases"])):
        for member in model.members.values():
            member.f(f"C{c}")
    return [built - started, solved - built, time.process_time() - solved]


def least(run, repeat):
    """The repeat of least sum."""
    return min((run() for _ in range(repeat)), key=sum)


def ours(program, path, repeat):
    """Mean CPU milliseconds of a solve, buffers kept, and the wall milliseconds of the phases of the quickest."""

    def run(times):
        command = [program, "solve", path, "--json", "--stations", "0", "--repeat", str(times)]
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        answer = subprocess.run(command, capture_output=True, text=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        if answer.returncode != 0:
            raise SystemExit(answer.stderr.strip())
        spent = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
        return spent, json.loads(answer.stdout)["timing_ms"]

    # Reading the file and writing the answer are in both and fall out.
    once = min(run(1)[0] for _ in range(3))
    many, phases = run(repeat + 1)
    return 1e3 * (many - once) / repeat, phases


def row(name, spent, mine):
    parts = [1e3 * s for s in spent]
    whole, lean = sum(parts), parts[0] + parts[1]
    print(
        f"  {name:<24}{parts[0]:>10.2f}{parts[1]:>10.2f}{parts[2]:>10.2f}{whole:>11.2f}"
        f"{whole / mine:>9.1f} x{lean / mine:>9.1f} x",
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frames", nargs="+")
    parser.add_argument("--houscaper", default=os.path.join(HERE, "../../target/release/houscaper"))
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--pynite-nodes", type=int, default=600)
    args = parser.parse_args()
    for path in args.frames:
        with open(path) as file:
            frame = Frame(json.load(file))
        print(f"{path}: {len(frame.nodes)} nodes, {len(frame.members)} members, {len(frame.data['cases'])} cases; ms")
        print(f"  {'':<24}{'build':>10}{'solve':>10}{'results':>10}{'sum':>11}{'ratio':>11}{'no results':>11}")
        times = max(20, 400_000 // len(frame.nodes))
        # Before and after the others: the machine may be busier at one time than at another.
        first = ours(args.houscaper, path, times)
        found = []
        for system in SYSTEMS:
            try:
                found.append((least(lambda: opensees(frame, system), args.repeat), system))
            except Exception as problem:
                print(f"  OpenSees {system}: {problem}")
        mine, timing = min(first, ours(args.houscaper, path, times), key=lambda t: t[0])
        phases = ", ".join(f"{k} {v:.2f}" for k, v in timing.items())
        print(f"  {'houscaper':<24}{'':>30}{mine:>11.2f}   wall, quickest: {phases}")
        if found:
            spent, system = min(found, key=lambda f: f[0][0] + f[0][1])
            row(f"OpenSees {system}", spent, mine)
        else:
            print("  OpenSees: none of its solvers took this frame")
        if len(frame.nodes) <= args.pynite_nodes:
            try:
                row("PyNite", least(lambda: pynite(frame), 1), mine)
            except ImportError:
                print("  PyNite: not installed (PyNiteFEA)")


if __name__ == "__main__":
    main()
