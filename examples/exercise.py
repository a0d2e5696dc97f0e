"""The course exercise written out: two balls on an L x 2L table, in steps of dt, with walls that damp."""

import matplotlib.pyplot as plt
import numpy as np

L, r, alpha, dt, duration = 1.0, 0.075, 0.8, 0.03, 5.0
after_wall = {None: (1, 1), 0: (-alpha, alpha), 1: (alpha, -alpha)}  # factors of the velocity, by the wall's axis


def getdt(x, v, dt):
    """For one ball: how long it moves in this step, cut short at the first wall ahead, and the axis of that wall."""
    wall = np.where(v < 0, r, [L - r, 2 * L - r])  # where the centre is when the ball touches the wall ahead
    hits = [(max(0.0, (wall[i] - x[i]) / v[i]), i) for i in (0, 1) if (x[i] + v[i] * dt - wall[i]) * v[i] > 0]
    return min(hits, default=(dt, None))


def getdt_ball(x, v, dt):
    """For both balls: the course's time to their contact, if they would be within 2r after this step; or else inf."""
    apart, closing = x[0] - x[1], v[0] - v[1]
    if np.linalg.norm(apart + closing * dt) > 2 * r or apart @ closing >= 0:
        return np.inf
    return np.clip((np.linalg.norm(apart) - 2 * r) / np.linalg.norm(closing), 0.0, dt)


def step(x, v, dt):
    """Make one step, and tell whether the balls met in it; a ball that hits something waits for the next step."""
    times, axes = zip(*(getdt(x[k], v[k], dt) for k in (0, 1)), strict=True)
    if (time := getdt_ball(x, v, dt)) <= min(times):
        n = (x[0] - x[1]) / np.linalg.norm(x[0] - x[1])
        exchange = n * (n @ (v[0] - v[1]))  # along n the velocities change places, along the tangent they stay
        return x + v * time, v + np.outer([-1, 1], exchange), True
    return x + v * np.reshape(times, (2, 1)), v * [after_wall[axis] for axis in axes], False


def simulate(x, v, times):
    """Give positions and velocities at all times, (n_times, 2 balls, 2) each, and the steps in which the balls met."""
    xs, vs, meetings = [x], [v], []
    for k, h in enumerate(np.diff(times)):
        x, v, met = step(x, v, h)
        xs, vs, meetings = [*xs, x], [*vs, v], meetings + [k] * met
    return np.array(xs), np.array(vs), meetings


def draw_disc_color(x, y, r, color):
    """Draw a filled disc, its outline given in polar coordinates."""
    angle = np.linspace(0, 2 * np.pi, 100)
    plt.fill(x + r * np.cos(angle), y + r * np.sin(angle), color)


if __name__ == "__main__":
    times = np.append(np.arange(0, duration, dt), duration)
    xs, vs, meetings = simulate(np.array([[0.1, 0.1], [0.5, 1.0]]), np.array([[3.0, 4.0], [0.0, 0.0]]), times)
    np.savetxt("mine.csv", np.c_[times, xs.reshape(-1, 4)], "%.17g", ",", header="t,xr,yr,xb,yb", comments="")
    plt.figure(figsize=(7, 4.2), layout="constrained")
    for place, k in enumerate(range(meetings[0], meetings[0] + 3), start=1):  # before, during and after the collision
        plt.subplot(1, 3, place, aspect="equal", xlim=(0, L), ylim=(0, 2 * L), title=f"t = {times[k]:.2f}")
        draw_disc_color(*xs[k, 0], r, "red")
        draw_disc_color(*xs[k, 1], r, "blue")
    plt.savefig("mine.png")
