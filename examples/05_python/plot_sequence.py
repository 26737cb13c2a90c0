# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the tracker knows of each object of a sequence over time: a table, and a plot if matplotlib is there.

usage: plot_sequence.py [SEQ [PICTURE.png]]

The cells, `# %%`, run one by one in Jupyter, VS Code or Spyder. Images are read with OpenCV for Python.
"""

# %% A sequence in the project's own layout
import sys
from pathlib import Path

import numpy as np

from dot_slam import Reason, State, Tracker
from dot_slam.sequence import DEPTH_UNITS_PER_METRE, Sequence

SAMPLE = Path(__file__).resolve().parents[1] / "data" / "mini"
sequence = Sequence(Path(sys.argv[1]) if len(sys.argv) > 1 else SAMPLE)
picture = Path(sys.argv[2]) if len(sys.argv) > 2 else Path("plot_sequence.png")

# %% Track it. A table's rows are copies, so that they can be kept.
tables, times = [], []
with Tracker(sequence.camera, depth_source=sequence.depth_source,
             depth_units_per_metre=DEPTH_UNITS_PER_METRE) as tracker:
    for frame in sequence:
        result = tracker.track(frame.image, frame.depth, frame.masks, timestamp=frame.timestamp)
        tables.append(result.table)
        times.append(np.full(len(result.table), frame.timestamp))
table, seconds = np.concatenate(tables), np.concatenate(times)


# %% The objects, as they were decided last. Columns of a structured array are arrays.
def speed_and_sigma(rows):
    """Of the fused velocity, and of that along itself."""
    velocity, covariance = rows["fused_velocity"], rows["fused_covariance"]
    speed = np.linalg.norm(velocity, axis=1)
    along = velocity / np.maximum(speed, 1e-9)[:, None]
    return speed, np.sqrt(np.einsum("ni,nij,nj->n", along, covariance, along))


print("object  frames  state           P(moving)  speed m/s  sigma m/s  range m, when last measured")
tracks = [(number, table["id"] == number) for number in np.unique(table["id"])]
for number, rows in tracks:
    last, measured = table[rows][-1:], table[rows & (table["reason"] == Reason.NONE)]
    (speed,), (sigma,) = speed_and_sigma(last)
    print(f"{number:6}  {rows.sum():6}  {State(last['last_decided'][0]).name.lower():14}  {last['p_moving'][0]:9.2f}  "
          f"{speed:9.2f}  {sigma:9.2f}  {measured[-1]['range'] if len(measured) else np.nan:7.1f}")

# %% Speed with its sigma, and the belief
try:
    import matplotlib
except ImportError:
    print("no matplotlib, hence no plot: apt install python3-matplotlib, or pip install matplotlib")
    sys.exit()
if "ipykernel" not in sys.modules:
    matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

figure, (speeds, beliefs, image) = plt.subplots(3, 1, figsize=(9, 10), constrained_layout=True)
beliefs.sharex(speeds)
for number, rows in tracks:
    measured = rows & (table["reason"] == Reason.NONE) & (table["fused_covariance"][:, 0, 0] > 0)
    speed, sigma = speed_and_sigma(table[measured])
    line, = speeds.plot(seconds[measured], speed, label=f"object {number}")
    speeds.fill_between(seconds[measured], speed - sigma, speed + sigma, color=line.get_color(), alpha=0.2)
    beliefs.plot(seconds[rows], table["p_moving"][rows], color=line.get_color())
speeds.set(ylabel="speed, m/s", ylim=(0, None))
speeds.legend(ncol=3, fontsize="small")
beliefs.set(xlabel="seconds", ylabel="P(moving)", ylim=(-0.03, 1.03))

shown = frame.image if frame.image.ndim == 3 else np.dstack([frame.image] * 3)
shown = shown[:, :, 2::-1] // 2
colours = {State.MOVING: (255, 120, 0), State.STATIC: (0, 200, 80), State.NOT_OBSERVABLE: (190, 190, 190)}
for state, colour in colours.items():
    shown[result.labels == state] = shown[result.labels == state] // 2 + np.array(colour, np.uint8) // 2
image.imshow(shown)
image.set(title=f"frame {frame.number}: orange moves, green stands, grey is not observable", xticks=[], yticks=[])
figure.savefig(picture, dpi=100)
print(f"written to {picture}")
