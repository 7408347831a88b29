# SPDX-License-Identifier: Apache-2.0
"""check_service.py BUILD: plays systemd for a daemon that has its configuration as it is shipped: it says when it is
ready, gives signs of life within the watchdog's interval while it waits for others, says that it stops when it is told
to, and keeps what it knows in its folder, where it goes on from when it was killed."""
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

INTERVAL = 2.0  # [s]


def messages_until(notified, deadline):
    """(seconds since the start, message) of what comes before the deadline."""
    start = time.monotonic()
    while (left := deadline - (time.monotonic() - start)) > 0:
        notified.settimeout(left)
        try:
            for line in notified.recv(4096).decode().splitlines():
                yield time.monotonic() - start, line
        except TimeoutError:
            return


def configured(folder, scenario):
    """The configuration as it is shipped, of another mission."""
    shipped = pathlib.Path(__file__).resolve().parents[2] / "daemons/service/ground.yaml"
    changed = {"scenario": scenario, "domain": 91}
    lines = [line for line in shipped.read_text().splitlines() if line.split(":")[0] not in changed]
    config = folder / "ground.yaml"
    config.write_text("\n".join(lines + [f"{key}: {value}" for key, value in changed.items()]) + "\n")
    return config


def check_memory(folder, start, notified):
    """Killed once it has kept something, it goes on from that."""
    process = start()
    assert any(line == "READY=1" for _, line in messages_until(notified, 30)), "not ready after 30 s"
    process.kill()
    process.wait()
    assert (folder / "ground.state").exists(), "it keeps nothing: killed, it would have forgotten all"
    process = start()
    assert any(line == "READY=1" for _, line in messages_until(notified, 30)), "not ready on its memory after 30 s"
    process.send_signal(signal.SIGTERM)
    assert process.wait(10) == 0, f"exit code {process.returncode}"
    aside = [file.name for file in folder.glob("*.aside-*")]
    assert not aside, f"its memory was set aside: {aside}"


def check(folder, daemon, scenario):
    notified = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    notified.bind(str(folder / "notify"))
    environment = dict(os.environ, NOTIFY_SOCKET=str(folder / "notify"), WATCHDOG_USEC=str(int(INTERVAL * 1e6)))
    config = configured(folder, scenario)
    work = folder / "work"  # as the unit's WorkingDirectory
    work.mkdir()

    def start():
        return subprocess.Popen([daemon, "--config", config], cwd=work, env=environment, stderr=subprocess.DEVNULL)

    check_memory(work, start, notified)
    process = start()
    try:
        ready = next((at for at, line in messages_until(notified, 30) if line == "READY=1"), None)
        assert ready is not None, "not ready after 30 s"
        alive = [at for at, line in messages_until(notified, 4 * INTERVAL) if line == "WATCHDOG=1"]
        gaps = [b - a for a, b in zip([0.0, *alive], [*alive, 4 * INTERVAL])]
        assert max(gaps) < INTERVAL, f"no sign of life for {max(gaps):.1f} s"
        process.send_signal(signal.SIGTERM)
        assert "STOPPING=1" in [line for _, line in messages_until(notified, 5)], "it does not say that it stops"
        assert process.wait(10) == 0, f"exit code {process.returncode}"
    finally:
        process.kill()
        process.wait()
    print(f"ready after {ready:.2f} s, {len(alive)} signs of life in {4 * INTERVAL:.0f} s")


def main():
    build = pathlib.Path(sys.argv[1])
    scenario = pathlib.Path(__file__).resolve().parents[2] / "scenarios/karma/detection.yaml"
    with tempfile.TemporaryDirectory() as folder:
        check(pathlib.Path(folder), build / "bin/skein-ground", scenario)


if __name__ == "__main__":
    main()
