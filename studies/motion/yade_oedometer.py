# Run by `yade -x -n -j1`: steps of an oedometer under water, from question.json in this folder to reply.json. The piston
# is the face y_max, drained; all others are closed and smooth. CPU seconds are of this process.
import json
import math
import os
import time

from yade import FlowEngine, config


def fastest():
    """Speed of the fastest grain, None when one's is no number."""
    speeds = [body.state.vel.norm() for body in O.bodies if isinstance(body.shape, Sphere)]
    return max(speeds) if all(math.isfinite(speed) for speed in speeds) else None


def finite(value):
    return value if math.isfinite(value) else None


def main():
    with open("question.json") as file:
        question = json.load(file)
    box, spheres = question["box"], question["spheres"]
    friction = math.atan(question["friction"])
    O.materials.append(FrictMat(young=question["young"], poisson=question["tangential_ratio"], frictionAngle=friction,
                                density=question["density"], label="grains"))
    # Walls are rigid: a spring of the pair then has twice the stiffness of one grain's.
    O.materials.append(FrictMat(young=1e6 * question["young"], poisson=question["tangential_ratio"], frictionAngle=0,
                                density=0, label="walls"))
    walls = O.bodies.append(aabbWalls([box[:3], box[3:]], thickness=0, material="walls"))
    O.bodies.append([sphere(one[:3], one[3], material="grains") for one in spheres])

    piston = TriaxialStressController(thickness=0, stressMask=2, internalCompaction=False, max_vel=0.005,
                                      goal1=0, goal2=-question["stress"], goal3=0, wall_bottom_activated=False)
    newton = NewtonIntegrator(damping=0.2)
    flow = FlowEngine(dead=1, defTolerance=0.3, meshUpdateInterval=200, useSolver=3, permeabilityFactor=1,
                      viscosity=question["viscosity"], bndCondIsPressure=[0, 0, 0, 1, 0, 0], bndCondValue=[0] * 6,
                      boundaryUseMaxMin=[0] * 6)
    O.engines = [
        ForceResetter(),
        InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Box_Aabb()]),
        InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                        [Law2_ScGeom_FrictPhys_CundallStrack()]),
        flow,
        GlobalStiffnessTimeStepper(active=1, timeStepUpdateInterval=100, timestepSafetyCoefficient=0.8),
        piston,
        newton,
    ]
    O.run(question["steps_at_rest"], True)

    O.engines[4].active = 0
    O.dynDt = False
    O.dt = question["step"]
    newton.damping = 0
    flow.dead = 0
    O.run(1, True)
    piston.goal2 = -question["stress"] - question["load"]
    height = O.bodies[walls[3]].state.pos[1]
    start = time.process_time()
    O.run(question["steps"], True)
    cpu = time.process_time() - start
    reply = {
        "version": config.version,
        "cpu_seconds": cpu / question["steps"],
        "settlement": finite(height - O.bodies[walls[3]].state.pos[1]),
        "fastest": fastest(),
        "cells": flow.nCells(),
    }
    with open("reply.json", "w") as file:
        json.dump(reply, file)


main()
os._exit(0)  # tearing down a scene can crash after the answer is written
