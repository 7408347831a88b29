# SPDX-License-Identifier: Apache-2.0
"""Colours that say something on the operators' pages are told apart by people with each kind of colour blindness, and read on their ground.

check_colours.py ASSETS_DIR

Apart: CIEDE2000 between each two of a group, as they are seen with protanopia, deuteranopia, tritanopia (Machado, Oliveira, Fernandes 2009, severity 1).
Read: contrast of WCAG 2.
"""
import itertools
import math
import pathlib
import re
import sys

SEEN = {
    "all colours": ((1, 0, 0), (0, 1, 0), (0, 0, 1)),
    "protanopia": ((0.152286, 1.052583, -0.204868), (0.114503, 0.786281, 0.099216), (-0.003882, -0.048116, 1.051998)),
    "deuteranopia": ((0.367322, 0.860646, -0.227968), (0.280085, 0.672501, 0.047413), (-0.011820, 0.042940, 0.968881)),
    "tritanopia": ((1.255528, -0.076749, -0.178779), (-0.078411, 0.930809, 0.147602), (0.004733, 0.691367, 0.303900)),
}
STATES_APART, UAVS_APART, CONTRAST = 12, 9, 3


def linear(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    return [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4 for c in parts]


def seen(rgb, matrix):
    return [min(1, max(0, sum(m * c for m, c in zip(row, rgb)))) for row in matrix]


def lab(rgb):
    """CIE L*a*b* of linear sRGB, white D65."""
    x = (0.4124564 * rgb[0] + 0.3575761 * rgb[1] + 0.1804375 * rgb[2]) / 0.95047
    y = 0.2126729 * rgb[0] + 0.7151522 * rgb[1] + 0.0721750 * rgb[2]
    z = (0.0193339 * rgb[0] + 0.1191920 * rgb[1] + 0.9503041 * rgb[2]) / 1.08883
    f = [t ** (1 / 3) if t > 216 / 24389 else (24389 / 27 * t + 16) / 116 for t in (x, y, z)]
    return 116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])


def ciede2000(one, other):
    """Sharma, Wu, Dalal 2005."""
    (l1, a1, b1), (l2, a2, b2) = one, other
    mean = (math.hypot(a1, b1) + math.hypot(a2, b2)) / 2
    g = 0.5 * (1 - math.sqrt(mean ** 7 / (mean ** 7 + 25 ** 7)))
    a1, a2 = a1 * (1 + g), a2 * (1 + g)
    c1, c2 = math.hypot(a1, b1), math.hypot(a2, b2)
    h1, h2 = (math.degrees(math.atan2(b, a)) % 360 if a or b else 0.0 for a, b in ((a1, b1), (a2, b2)))
    dh = 0.0 if c1 * c2 == 0 else (h2 - h1 + 180) % 360 - 180
    dl, dc, dH = l2 - l1, c2 - c1, 2 * math.sqrt(c1 * c2) * math.sin(math.radians(dh) / 2)
    lm, cm = (l1 + l2) / 2, (c1 + c2) / 2
    hm = h1 + h2 if c1 * c2 == 0 else (h1 + h2) / 2 if abs(h1 - h2) <= 180 else (h1 + h2 + 360) / 2 if h1 + h2 < 360 else (h1 + h2 - 360) / 2
    t = (1 - 0.17 * math.cos(math.radians(hm - 30)) + 0.24 * math.cos(math.radians(2 * hm))
         + 0.32 * math.cos(math.radians(3 * hm + 6)) - 0.20 * math.cos(math.radians(4 * hm - 63)))
    sl = 1 + 0.015 * (lm - 50) ** 2 / math.sqrt(20 + (lm - 50) ** 2)
    sc, sh = 1 + 0.045 * cm, 1 + 0.015 * cm * t
    rt = -math.sin(math.radians(60 * math.exp(-(((hm - 275) / 25) ** 2)))) * 2 * math.sqrt(cm ** 7 / (cm ** 7 + 25 ** 7))
    return math.sqrt((dl / sl) ** 2 + (dc / sc) ** 2 + (dH / sh) ** 2 + rt * (dc / sc) * (dH / sh))


def contrast(one, other):
    light, dark = sorted((0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2] for c in (linear(one), linear(other))), reverse=True)
    return (light + 0.05) / (dark + 0.05)


def check_measure():
    """Two pairs of the published test data."""
    assert abs(ciede2000((50, 2.6772, -79.7751), (50, 0, -82.7485)) - 2.0425) < 1e-4
    assert abs(ciede2000((60.2574, -34.0099, 36.2677), (60.4626, -34.1751, 39.4387)) - 1.2644) < 1e-4


def main():
    assets = pathlib.Path(sys.argv[1])
    style = (assets / "style.css").read_text()
    colour = {name: re.search(rf"--{name}: (#[0-9a-f]{{6}})", style).group(1) for name in ("back", "room", "good", "warn", "bad", "hand", "text", "dim")}
    uavs = re.findall(r'"(#[0-9a-f]{6})"', re.search(r"const colours = \[(.*?)\]", (assets / "feed.js").read_text()).group(1))
    check_measure()
    wrong = 0
    for name, group, least in (("states", [colour[one] for one in ("good", "warn", "bad", "hand")], STATES_APART), ("UAVs", uavs, UAVS_APART)):
        assert len(group) >= 4
        for who, matrix in SEEN.items():
            nearest = min(((ciede2000(lab(seen(linear(a), matrix)), lab(seen(linear(b), matrix))), a, b) for a, b in itertools.combinations(group, 2)))
            print(f"{name}, {who}: the nearest two, {nearest[1]} and {nearest[2]}, are {nearest[0]:.1f} apart")
            if nearest[0] < least:
                wrong += 1
                print(f"  expected at least {least}")
    for name in ("good", "warn", "bad", "hand", "text", "dim"):
        if contrast(colour[name], colour["room"]) < CONTRAST:
            wrong += 1
            print(f"--{name} is hard to read on --room: contrast {contrast(colour[name], colour['room']):.1f}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
