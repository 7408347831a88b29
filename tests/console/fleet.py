# SPDX-License-Identifier: Apache-2.0
"""Scenarios of as many helicopters as asked, which wait for their operators."""


def fleet(count, source, cut=False, until=3500):
    names = ["marvin"] + [f"heli{number}" for number in range(2, count + 1)]
    uavs = "\n".join(f"  {name}: {{model: {source}/scenarios/comets/models/marvin.yaml, start: [{40 * (i % 5)}, {40 * (i // 5)}], degree: 4}}"
                     for i, name in enumerate(names))
    pads = "\n".join(f"    pad-{name}: [{40 * (i % 5)}, {40 * (i // 5)}, 0]" for i, name in enumerate(names))
    work = "\n".join(f"        - mission: {{uav: {name}, id: 1, tasks: [{{id: {10 * i + 1}, task: [general-takeoff]}}, "
                     f"{{id: {10 * i + 2}, task: [perform-detection, Z, P, 600]}}]}}" for i, name in enumerate(names))
    script = f"    - step: fly\n      when: {{time: 5}}\n      do:\n{work}\n" if count > 1 else ""
    cuts = "  cuts: [{between: [marvin, ground], from: 90, until: 150}]\n" if cut else ""
    return f"""scenario: fleet
epoch: 2005-05-19T09:00:00Z
duration_limit: 3600
world:
  include: {source}/scenarios/worlds/lousa.yaml
  zones:
    A: [[-200, -200], [-100, -200], [-100, -100], [-200, -100]]
    Z: [[260, 60], [460, 60], [460, 200], [260, 200]]
  places:
    P: [300, 100, 0]
{pads}
uavs:
{uavs}
planning: {{domain: {source}/scenarios/domains/comets.lisp, altitude: 40, voxel: 20, risk: 0.2}}
radio:
  range: 3000
  latency: 0.02
{cuts}ground:
  position: [-20, -20, 8]
  script:
{script}    - step: end
      when: {{time: {until}}}
      do: [{{finish: true}}]
"""
