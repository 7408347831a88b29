# SPDX-License-Identifier: Apache-2.0
"""check_service.py BUILD: plays systemd for a daemon that has its configuration as it is shipped: it says when it is
ready, gives signs of life within the watchdog's interval while it waits for others, and none once its loop stands
still, dies of SIGABRT then, says that it stops when it is told to, and keeps what it knows in its folder, where it goes
on from when it was killed. (systemd itself: check_systemd.sh.)"""
import contextlib
import ctypes
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

INTERVAL = 2.0  # [s]
SEIZE, INTERRUPT, DETACH = 0x4206, 0x4207, 17  # sys/ptrace.h
ALL_CHILDREN = 0x40000000  # __WALL


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


def ready(notified):
    """After how many seconds it said so."""
    at = next((at for at, line in messages_until(notified, 30) if line == "READY=1"), None)
    assert at is not None, "not ready after 30 s"
    return at


def goes_on(folder, start, notified):
    """Started again, it has what its life before it knew."""
    process = start()
    ready(notified)
    process.send_signal(signal.SIGTERM)
    assert process.wait(10) == 0, f"exit code {process.returncode}"
    aside = [file.name for file in folder.glob("*.aside-*")]
    assert not aside, f"its memory was set aside: {aside}"


def check_memory(folder, start, notified):
    """Killed once it has kept something, it goes on from that."""
    process = start()
    ready(notified)
    process.kill()
    process.wait()
    assert (folder / "ground.state").exists(), "it keeps nothing: killed, it would have forgotten all"
    goes_on(folder, start, notified)


@contextlib.contextmanager
def standing_still(process):
    """Its main thread, and nothing else of it."""
    trace = ctypes.CDLL(None, use_errno=True).ptrace

    def ask(what):
        if trace(what, process.pid, None, None) != 0:
            raise OSError(ctypes.get_errno(), f"ptrace {what:#x} of the daemon")

    ask(SEIZE)
    ask(INTERRUPT)
    os.waitpid(process.pid, ALL_CHILDREN)
    try:
        yield
    finally:
        with contextlib.suppress(ProcessLookupError):  # SIGABRT may have ended it by now
            ask(DETACH)


def check_watchdog(folder, start, notified):
    """Other threads give no signs of life for a loop that stands still, and SIGABRT ends it."""
    process = start()
    try:
        ready(notified)
        with standing_still(process):
            list(messages_until(notified, 0.2))  # what was on its way
            alive = [line for _, line in messages_until(notified, 2 * INTERVAL) if line == "WATCHDOG=1"]
            assert not alive, "signs of life of a loop that stands still: no watchdog would fire"
            process.send_signal(signal.SIGABRT)
        assert process.wait(10) == -signal.SIGABRT, f"exit code {process.returncode}"
    finally:
        process.kill()
        process.wait()
    goes_on(folder, start, notified)


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
    check_watchdog(work, start, notified)
    process = start()
    try:
        after = ready(notified)
        alive = [at for at, line in messages_until(notified, 4 * INTERVAL) if line == "WATCHDOG=1"]
        gaps = [b - a for a, b in zip([0.0, *alive], [*alive, 4 * INTERVAL])]
        assert max(gaps) < INTERVAL, f"no sign of life for {max(gaps):.1f} s"
        process.send_signal(signal.SIGTERM)
        assert "STOPPING=1" in [line for _, line in messages_until(notified, 5)], "it does not say that it stops"
        assert process.wait(10) == 0, f"exit code {process.returncode}"
    finally:
        process.kill()
        process.wait()
    print(f"ready after {after:.2f} s, {len(alive)} signs of life in {4 * INTERVAL:.0f} s")


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    scenario = pathlib.Path(__file__).resolve().parents[2] / "scenarios/karma/detection.yaml"
    with tempfile.TemporaryDirectory() as folder:
        check(pathlib.Path(folder), build / "bin/skein-ground", scenario)


if __name__ == "__main__":
    main()
