#!/usr/bin/env python3
"""Compares `houscaper solve` with OpenSees, frame by frame.

    opensees_compare.py [--houscaper PROGRAM] [--tolerance 1e-8] [--samples] [FRAME.json ...]

FRAME.json: frames in the format houscaper.frame/1. --samples: builds every house that comes with the program (`houscaper
build sample:NAME`), some of them in other sections, and compares all of those.

Prints one line a frame: its size, and for translations, rotations, reaction forces and moments, end forces and moments the
largest difference over all load cases, relative to the largest value of the same kind in that load case. Exit code 0: all
within the tolerance; 1: some frame is not, or one of the programs failed; 3: openseespy is not there.

Needs openseespy from PyPI (on Debian also libopenblas0-pthread) and numpy; best in a virtual environment of its own:
    python3 -m venv target/venv && target/venv/bin/pip install openseespy numpy
    apt-get install libopenblas0-pthread
    cargo build --release && target/venv/bin/python tests/tools/opensees_compare.py --samples
What OpenSees' beam cannot do (linear loads, Timoshenko with releases, releases other than bending) is said and not compared.
"""
import argparse
import json
import math
import os
import subprocess
import sys
import tempfile

try:
    import numpy as np
    import openseespy.opensees as ops
except Exception as problem:  # the wheel raises RuntimeError when the BLAS library is missing
    print(f"skipped: openseespy or numpy cannot be imported ({problem}); see the head of this script", file=sys.stderr)
    sys.exit(3)

HERE = os.path.dirname(os.path.abspath(__file__))
KINDS = ["translation", "rotation", "reaction", "reac moment", "end force", "end moment"]
# Every second house is compared once more in these sections.
OTHER_CHOICES = json.dumps(
    {
        "wall_section": "S355 SHS200x200x6.3",
        "floor_section": "S355 SHS180x180x6",
        "beam_section": "S355 IPE160",
        "roof_section": "S355 SHS200x200x6.3",
    }
)


class NotComparable(Exception):
    """The frame has something that OpenSees' elements do not."""


def local_axes(start, end, reference, roll):
    """Rows x, y, z: the convention of the frame format, written down a second time on purpose."""
    x = (end - start) / np.linalg.norm(end - start)
    if reference is not None:
        v = np.array(reference, float)
    elif math.hypot(x[0], x[1]) > 1e-9:
        v = np.array([0.0, 0.0, 1.0])
    else:
        v = np.array([-1.0 if x[2] > 0 else 1.0, 0.0, 0.0])
    y = np.cross(v, x)
    y /= np.linalg.norm(y)
    z = np.cross(x, y)
    c, s = math.cos(math.radians(roll)), math.sin(math.radians(roll))
    return np.array([x, c * y + s * z, c * z - s * y])


class Frame:
    """A frame file in arrays."""

    def __init__(self, data):
        self.data = data
        self.nodes = np.array(data["nodes"], float)
        self.members = data["members"]
        self.ends = np.array([m["n"] for m in self.members], int)
        self.axes = [
            local_axes(self.nodes[i], self.nodes[j], m.get("ref"), m.get("roll", 0.0))
            for m, (i, j) in zip(self.members, self.ends)
        ]
        self.lengths = np.linalg.norm(self.nodes[self.ends[:, 1]] - self.nodes[self.ends[:, 0]], axis=1)
        self.fixed = np.zeros((len(self.nodes), 6), bool)
        for support in data["supports"]:
            self.fixed[support["node"]] |= np.array(support["fix"], bool)

    def of(self, member, table, key):
        which = {"materials": "mat", "sections": "sec"}[table]
        return float(self.data[table][self.members[member][which]][key])

    def bending_releases(self, m):
        """Codes of OpenSees for the releases about z and y: 1 at i, 2 at j, 3 both."""
        releases = self.members[m].get("releases", {})
        at = [np.array(releases.get(end, [0] * 6), bool) for end in "ij"]
        if any(r[:4].any() for r in at):
            raise NotComparable(f"member {m} releases more than bending")
        return [int(at[0][d]) + 2 * int(at[1][d]) for d in (5, 4)]

    def loads(self, case):
        """(member, place or None, force in local axes): uniform loads and points of a case."""
        gravity = np.array(case.get("gravity", [0, 0, 0]), float)
        for m in range(len(self.members)):
            mass = float(self.data["materials"][self.members[m]["mat"]].get("rho", 0.0)) * self.of(m, "sections", "A")
            if gravity.any() and mass:
                yield m, None, self.axes[m] @ (mass * gravity)
        for load in case.get("member", []):
            m = load["m"]
            turn = self.axes[m] if load["axes"] == "global" else np.eye(3)
            if load["type"] == "uniform":
                yield m, None, turn @ np.array(load["q"], float)
            elif load["type"] == "point":
                yield m, load["x"] / self.lengths[m], turn @ np.array(load["P"], float)
            else:
                raise NotComparable(f"linear load on member {m}")


def build(frame, idle):
    """The frame in OpenSees; directions that nothing resists and nothing loads (`idle`) are held as well."""
    ops.wipe()
    ops.model("basic", "-ndm", 3, "-ndf", 6)
    for n, place in enumerate(frame.nodes.tolist()):
        ops.node(n + 1, *place)
    held = frame.fixed.copy()
    for direction in idle:
        along = np.array(direction["direction"])
        dof = int(np.argmax(np.abs(along)))
        if abs(along[dof]) < 1 - 1e-9:
            raise NotComparable(f"node {direction['node']} turns freely about an oblique axis")
        held[direction["node"], dof] = True
    for n in np.nonzero(held.any(axis=1))[0]:
        ops.fix(int(n) + 1, *(int(h) for h in held[n]))
    shear = bool(frame.data.get("shear", False))
    for m, (i, j) in enumerate(frame.ends.tolist()):
        ops.geomTransf("Linear", m + 1, *frame.axes[m][2].tolist())
        e, g = frame.of(m, "materials", "E"), frame.of(m, "materials", "G")
        a, iy, iz, torsion = (frame.of(m, "sections", key) for key in ("A", "Iy", "Iz", "J"))
        about_z, about_y = frame.bending_releases(m)
        if shear:
            if about_z or about_y:
                raise NotComparable("Timoshenko members with releases")
            areas = [frame.of(m, "sections", key) for key in ("Asy", "Asz")]
            ops.element("ElasticTimoshenkoBeam", m + 1, i + 1, j + 1, e, g, a, torsion, iy, iz, *areas, m + 1)
            continue
        released = ["-releasez", about_z] if about_z else []
        released += ["-releasey", about_y] if about_y else []
        ops.element("elasticBeamColumn", m + 1, i + 1, j + 1, a, e, g, torsion, iy, iz, m + 1, *released)


def opensees(frame, idle):
    """Displacements, reactions and end forces of all cases."""
    build(frame, idle)
    settles = any(case.get("settle") for case in frame.data["cases"])
    ops.constraints("Transformation" if settles else "Plain")
    ops.numberer("RCM")
    ops.system("UmfPack")
    ops.algorithm("Linear")
    ops.timeSeries("Constant", 1)
    ops.integrator("LoadControl", 0.0)
    ops.analysis("Static")
    answers = []
    for c, case in enumerate(frame.data["cases"]):
        ops.reset()  # every case starts from rest, or it inherits the rounding of the one before
        ops.pattern("Plain", c + 1, 1)
        for load in case.get("nodal", []):
            ops.load(load["node"] + 1, *(float(f) for f in load["F"]))
        for m, place, q in frame.loads(case):
            if place is None:
                ops.eleLoad("-ele", m + 1, "-type", "-beamUniform", q[1], q[2], q[0])
            else:
                ops.eleLoad("-ele", m + 1, "-type", "-beamPoint", q[1], q[2], place, q[0])
        for s in case.get("settle", []):
            ops.sp(s["node"] + 1, s["dof"] + 1, float(s["value"]))
        if ops.analyze(1) != 0:
            raise RuntimeError("OpenSees could not solve it")
        ops.reactions()
        disp = np.array([ops.nodeDisp(n + 1) for n in range(len(frame.nodes))])
        reac = np.array([ops.nodeReaction(n + 1) for n in range(len(frame.nodes))]) * frame.fixed
        ends = np.array([ops.eleResponse(m + 1, "localForce") for m in range(len(frame.members))])
        answers.append((disp, reac, ends))
        ops.remove("loadPattern", c + 1)
    ops.wipe()
    return answers


def by_kind(disp, reac, ends):
    ends = ends.reshape(len(ends), 2, 6)
    return [disp[:, :3], disp[:, 3:], reac[:, :3], reac[:, 3:], ends[:, :, :3], ends[:, :, 3:]]


def differences(ours, theirs):
    """Largest relative difference of each kind over all cases."""
    worst = np.zeros(len(KINDS))
    for a, b in zip(ours, theirs):
        for k, (x, y) in enumerate(zip(by_kind(*a), by_kind(*b))):
            scale = np.abs(y).max(initial=0.0)
            gap = np.abs(x - y).max(initial=0.0)
            if not math.isfinite(gap):
                worst[k] = math.inf
            elif gap > 0.0:
                worst[k] = max(worst[k], gap / scale if scale > 0.0 else math.inf)
    return worst


def houscaper(program, path):
    """The status, the idle directions and the answers of our own solver."""
    run = subprocess.run([program, "solve", path, "--json", "--stations", "0"], capture_output=True, text=True)
    if run.returncode != 0:
        raise RuntimeError(run.stderr.strip())
    answer = json.loads(run.stdout)
    cases = [tuple(np.array(c[key], float) for key in ("disp", "reac", "endf")) for c in answer["cases"]]
    return answer["status"], answer["idle"], cases


def sample_names(program):
    """The program names its sample houses when asked for one that does not exist."""
    said = subprocess.run([program, "build", "sample:?", "--out", os.devnull], capture_output=True, text=True).stderr
    return [name.strip() for name in said.split("there are", 1)[1].split(",")]


def sample_frames(program, folder):
    names = sample_names(program)
    for name, choices in [(name, None) for name in names] + [(name, OTHER_CHOICES) for name in names[::2]]:
        out = os.path.join(folder, f"{name}{'-other-sections' if choices else ''}")
        more = ["--choices", choices] if choices else []
        run = subprocess.run([program, "build", f"sample:{name}", "--out", out, *more], capture_output=True, text=True)
        if run.returncode != 0:
            raise SystemExit(f"houscaper build sample:{name} failed: {run.stderr.strip()}")
        yield os.path.join(out, "frame.json")


def compare(program, path, tolerance):
    """Prints the line of one frame; whether it was compared, and whether it agrees."""
    name = os.path.basename(path)
    name = os.path.basename(os.path.dirname(path)) if name == "frame.json" else name.removesuffix(".json")
    with open(path) as file:
        frame = Frame(json.load(file))
    size = f"{name:<24} {len(frame.nodes):>6} {len(frame.members):>7} {len(frame.data['cases']):>5}"
    try:
        status, idle, ours = houscaper(program, path)
        if status != "solved":
            print(f"{size}  houscaper says: {status}")
            return True, False
        worst = differences(ours, opensees(frame, idle))
    except NotComparable as reason:
        print(f"{size}  not compared: {reason}")
        return False, True
    except RuntimeError as problem:
        print(f"{size}  FAILED: {problem}")
        return True, False
    good = bool((worst <= tolerance).all())
    print(f"{size}  " + " ".join(f"{w:>11.1e}" for w in worst) + ("" if good else "  DIFFERENT"), flush=True)
    return True, good


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("frames", nargs="*")
    parser.add_argument("--houscaper", default=os.path.join(HERE, "../../target/release/houscaper"))
    parser.add_argument("--tolerance", type=float, default=1e-8)
    parser.add_argument("--samples", action="store_true")
    args = parser.parse_args()
    if not args.frames and not args.samples:
        parser.error("name frame files, or ask for --samples")
    print(f"{'frame':<24} {'nodes':>6} {'members':>7} {'cases':>5}  " + " ".join(f"{k:>11}" for k in KINDS))
    with tempfile.TemporaryDirectory() as folder:
        frames = list(args.frames)
        if args.samples:
            frames += sample_frames(args.houscaper, folder)
        results = [compare(args.houscaper, path, args.tolerance) for path in frames]
    compared = sum(c for c, _ in results)
    agree = sum(c and g for c, g in results)
    version = ops.version()
    print(f"{agree} of {compared} frames agree with OpenSees {version} to {args.tolerance:g}; {len(results) - compared} not compared")
    sys.exit(0 if agree == compared and compared > 0 else 1)


if __name__ == "__main__":
    main()
