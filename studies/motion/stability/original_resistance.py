# Run by `yade -x -n -j1`: how the fluid resists the motion of every sphere along every axis, from question.json in this
# folder to reply.json. FlowEngine takes velocities from where spheres were in the step before, so each is moved by what a
# unit velocity makes of a very short step, and back.
import json
import os

from yade import FlowEngine, config

STEP = 1e-7  # s; a millionth of a radius: far above round-off in volumes, far below what bends


def main():
    with open("question.json") as file:
        question = json.load(file)
    box, spheres = question["box"], question["spheres"]
    O.materials.append(FrictMat(label="solid"))
    walls = O.bodies.append(aabbWalls([box[:3], box[3:]], thickness=0, material="solid"))
    ids = O.bodies.append([sphere(one[:3], one[3], material="solid") for one in spheres])

    flow = FlowEngine(useSolver=4, defTolerance=-1, meshUpdateInterval=10**9)
    flow.wallIds = walls
    flow.bndCondIsPressure = [False, False, False, False, True, True]
    flow.bndCondValue = [0.0] * 6
    flow.boundaryUseMaxMin = [False] * 6
    flow.viscosity = 1.0
    flow.slipBoundary = True
    O.engines = [ForceResetter(), flow]
    O.dt = STEP
    flow.emulateAction()
    flow.emulateAction()

    columns = []
    for moving in ids:
        state = O.bodies[moving].state
        start = state.pos
        for axis in range(3):
            there = Vector3(start)
            there[axis] += STEP
            state.pos = there
            flow.emulateAction()
            columns.append([-part for i in ids for part in flow.fluidForce(i)])
            state.pos = start
            flow.emulateAction()
    with open("reply.json", "w") as file:
        json.dump({"version": config.version, "columns": columns}, file)


main()
os._exit(0)  # tearing down a scene can crash after the answer is written
