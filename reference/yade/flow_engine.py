# Run by `yade -x -n -j1`: one steady flow by FlowEngine along an axis under a unit pressure drop, with unit viscosity,
# from question.json and packing.txt in this folder to reply.json.
# CPU seconds are of this process; the engine's own timers, which are of wall time, divide them among its stages.
import json
import math
import os
import time

from yade import FlowEngine, config

REPEATS = 3


def status_bytes(key):
    with open("/proc/self/status") as status:
        for line in status:
            if line.startswith(key):
                return 1024 * int(line.split()[1])
    return 0


def restart_peak_memory():
    with open("/proc/self/clear_refs", "w") as switch:
        switch.write("5")


def read_packing():
    box, spheres = None, []
    with open("packing.txt") as packing:
        for line in packing:
            if line.startswith("# box"):
                box = [float(word) for word in line.split()[2:]]
            elif line.strip() and not line.startswith("#"):
                spheres.append([float(word) for word in line.split()])
    return box, spheres


def read_points():
    with open("points.txt") as points:
        return [[float(word) for word in line.split()] for line in points]


def iteration(flow):
    """CPU seconds of one call, shared out by the engine's own timers."""
    flow.timingDeltas.reset()
    start = time.process_time()
    flow.emulateAction()
    cpu = time.process_time() - start
    shares = {"network": 0.0, "solve": 0.0, "forces": 0.0}
    stage_of = {"Triangulating": "network", "Factorize + Solve": "solve"}
    for name, nanoseconds, _ in flow.timingDeltas.data:
        shares[stage_of.get(name, "forces")] += nanoseconds
    whole = sum(shares.values())
    return {stage: cpu * share / whole for stage, share in shares.items()}


def finite(value):
    return value if math.isfinite(value) else None


def main():
    with open("question.json") as file:
        question = json.load(file)
    box, spheres = read_packing()
    O.materials.append(FrictMat(label="solid"))
    walls = O.bodies.append(aabbWalls([box[:3], box[3:]], thickness=0, material="solid"))
    ids = O.bodies.append([sphere(one[:3], one[3], material="solid") for one in spheres])

    flow = FlowEngine(useSolver=question["solver"])
    flow.wallIds = walls
    lower = 2 * question["axis"]
    flow.bndCondIsPressure = [face in (lower, lower + 1) for face in range(6)]
    flow.bndCondValue = [float(face == lower + 1) for face in range(6)]
    flow.boundaryUseMaxMin = [False] * 6  # the planes of the walls, not those around the spheres
    flow.viscosity = 1.0
    flow.slipBoundary = True
    flow.meshUpdateInterval = 10**9
    O.engines = [ForceResetter(), flow]
    O.dt = 1e-9
    O.timingEnabled = True

    # Nothing moves, so a second call keeps triangulation, conductances and factors.
    before = status_bytes("VmRSS:")
    restart_peak_memory()
    first = iteration(flow)
    repeated = min((iteration(flow) for _ in range(REPEATS)), key=lambda stages: sum(stages.values()))
    peak = status_bytes("VmHWM:")
    reply = {
        "version": config.version,
        "cells": flow.nCells(),
        "flux_out": finite(flow.getBoundaryFlux(walls[lower])),
        "flux_in": finite(-flow.getBoundaryFlux(walls[lower + 1])),
        "forces": [[finite(part) for part in flow.fluidForce(i)] for i in ids],
        "pressures": [finite(flow.getPorePressure(point)) for point in read_points()],
        "first": first,
        "repeated": repeated,
        "memory_before": before,
        "peak_memory": peak,
    }
    with open("reply.json", "w") as file:
        json.dump(reply, file)


main()
os._exit(0)  # tearing down a scene can crash after the answer is written
