"""Sweeps through Dask: a real scheduler and workers, killed in the middle of rows; bitwise the rows of one machine."""

import os
import signal
import subprocess
import sys
import threading
import time
from contextlib import contextmanager
from pathlib import Path

import numpy as np
import pytest
from commands import called
from handmade import point

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, simulate_many, sweep
from hertzwerk.runtime.loading import engine_model
from hertzwerk.runtime.studies.sweeps.batch import engine_of
from hertzwerk.runtime.studies.sweeps.rows import cluster

ASKED = {"over": {"drop_height": "0.3..0.5 m:12"}, "duration": "0.5 s"}
ASKED |= {"outputs": ["floor.peak_force", "final.vertical.travel"]}
DASK = [sys.executable, "-m", "dask"]


class Cluster:
    """A scheduler and workers of one thread each, processes of this machine."""

    def __init__(self, folder, workers, **environment):
        self._folder, self._environment = folder, {**os.environ, **environment}
        self.processes = []
        file = folder / "scheduler.json"
        self.scheduler = self._start("scheduler", "--host", "127.0.0.1", "--port", "0", "--scheduler-file", str(file))
        until(file.exists)
        self._file = file
        for _ in range(workers):
            self.add()

    def add(self):
        """Start a worker."""
        options = ("--nthreads", "1", "--no-nanny", "--local-directory", str(self._folder))
        self._start("worker", "--scheduler-file", str(self._file), *options)

    def _start(self, *command):
        log = (self._folder / f"{len(self.processes)}.log").open("w")
        with log:
            self.processes.append(
                subprocess.Popen([*DASK, *command, "--no-dashboard"], env=self._environment, stdout=log, stderr=log)
            )
        return self.processes[-1]

    def connected(self):
        return cluster.Client(scheduler_file=str(self._file), set_as_default=False)

    def end(self):
        for process in self.processes:
            process.kill()
            process.wait()


def until(there, patience=240):
    deadline = time.monotonic() + patience
    while not there():
        assert time.monotonic() < deadline
        time.sleep(0.05)


@contextmanager
def running(folder, workers, **environment):
    """A cluster, and a client that is connected with it."""
    made = Cluster(folder, workers, **environment)
    try:
        with made.connected() as client:
            client.wait_for_workers(workers, timeout=240)
            yield made, client
    finally:
        made.end()


@pytest.fixture(scope="module")
def two(tmp_path_factory):
    with running(tmp_path_factory.mktemp("cluster"), 2) as made:
        yield made


@pytest.fixture(scope="module")
def client(two):
    return two[1]


def same(one, other):
    """Whether two tables are the same to the bit, times apart."""
    texts = ("outcome", "message", "warnings")
    assert one.names == other.names
    return [
        name
        for name in one.names
        if name != "wall_s"
        and not np.array_equal(*(each[name] if name in texts else each[name].view(np.uint64) for each in (one, other)))
    ] == []


def highest(run):
    return top(run["vertical.travel"])


def top(history):
    return float(np.max(history))


@pytest.mark.slow
@pytest.mark.parametrize("compiled", [pytest.param("auto", marks=pytest.mark.exhaustive), True])
def test_rows_are_those_of_one_machine_to_the_bit(client, compiled, tmp_path):
    """Functions come with what they use of their module, which no worker can import."""
    scale = 3.0
    functions = {"highest": highest, "scaled": lambda run: scale * run.engine.t_end}
    options = {"section": "floor.gap = 0 m falling", "histories": ["vertical.speed"]}
    alone, together = (
        sweep("bouncing_ball", **ASKED, **options, functions=functions, compiled=compiled, out=tmp_path / name, **who)
        for name, who in {"alone": {"workers": 2}, "together": {"client": client}}.items()
    )
    assert together.counts() == {"finished": 12}
    assert same(alone, together)
    assert alone.section.points > 0
    assert together.section.record() == alone.section.record()
    assert together.workers == 2
    assert together.compiled or compiled == "auto"
    assert not same(alone, sweep("bouncing_ball", **ASKED, functions={**functions, "highest": lambda run: 0.0}))
    outside = sweep(
        "bouncing_ball", **ASKED, functions={"process": lambda run: os.getpid()}, compiled=True, client=client
    )
    assert os.getpid() not in outside["process"]


@pytest.mark.slow
def test_failures_are_rows_of_batches_too(client):
    sets = [{"mass": "-1 kg"}, {"drop_height": "0.3 m"}, {"mass": "1 m"}, {"drop_height": "20 m"}]
    outputs = {"second": lambda run: run.impacts[1].speed}
    options = {"duration": "1 s", "tolerance": 1e-6, "functions": outputs, "compiled": False}
    alone, together = (
        simulate_many(engine_model("bouncing_ball"), sets, **options, **who) for who in ({}, {"client": client})
    )
    assert list(together["outcome"]) == ["bad_input", "finished", "bad_input", "bad_output"]
    assert same(alone, together)


@pytest.mark.slow
def test_versions_that_differ_are_refused_by_name(client, monkeypatch):
    here = engine_of(None, client)
    real = cluster.versions()
    monkeypatch.setattr(cluster, "versions", lambda: {**real, "casadi": "3.0.0", "code": "another"})
    with pytest.raises(InputError) as error:
        sweep("bouncing_ball", **ASKED, client=client)
    assert len(error.value.faults) == 4  # of two workers
    assert all(fault.where.startswith("worker tcp://") for fault in error.value.faults)
    assert {fault.where.split(", ")[1] for fault in error.value.faults} == {"casadi", "code"}
    from hertzwerk.runtime.engine.run.run_request import Settings
    from hertzwerk.runtime.studies.sweeps.rows.row_job import Job, Tasks

    job = Job(engine_model("bouncing_ball"), Settings("1 s", None, 1e-6), [])
    with pytest.raises(InputError, match=r"3\.0\.0"):  # of a worker that came after the first look
        list(here.rows(job, Tasks([(0, {})])))


@pytest.mark.slow
def test_an_object_that_cannot_be_sent_is_one_clear_error(client):
    lock = threading.Lock()
    with pytest.raises(InputError, match="functions that pickle"):
        how = {"duration": "1 s", "compiled": False, "functions": {"x": lambda run: lock.locked()}}
        simulate_many("bouncing_ball", [{}], client=client, **how)
    free = point(lambda d, v, v0: 1e6 * d)
    with pytest.raises(InputError, match="generated text"):
        simulate_many(free, [{}], duration=0.01, client=client, compiled=False)


def test_bad_clients_are_bad_input_and_without_dask_the_extra_is_named(monkeypatch):
    with pytest.raises(InputError, match=r"distributed\.Client"):
        sweep("bouncing_ball", **ASKED, client="tcp://127.0.0.1:8786")
    with pytest.raises(InputError, match="beside a client"):
        sweep("bouncing_ball", **ASKED, client=object(), workers=2)
    monkeypatch.setitem(sys.modules, "distributed", None)
    over = ("--over", "drop_height=1,2")
    assert "hertzwerk[cluster]" in called("sweep", "bouncing_ball", *over, "--cluster", "tcp://host:1", code=2).stderr
    with pytest.raises(InputError, match=r"hertzwerk\[cluster\]"):
        sweep("bouncing_ball", **ASKED, client=object())


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "nowhere", "tcp://127.0.0.1:x", "foo://x:1"])
def test_a_scheduler_that_is_not_there_is_one_clear_error(address, monkeypatch, tmp_path):
    monkeypatch.setattr(cluster, "PATIENCE", 0.3)
    options = ["--over", "drop_height=0.3..0.5 m:3", "--duration", "0.5 s", "--out", str(tmp_path / "rows")]
    assert "no scheduler" in called("sweep", "bouncing_ball", *options, "--cluster", address, code=2).stderr
    assert not (tmp_path / "rows").exists()


@pytest.mark.slow
def test_a_worker_killed_in_a_row_costs_that_row_alone(two, tmp_path):
    """The row of 0.4 m tells its process and waits, the first time."""
    text = str(tmp_path / "told")

    def waits(run):
        if abs(run.engine.initial["vertical.travel"] - 0.5) < 1e-9 and not os.path.lexists(text):
            Path(text).symlink_to(str(os.getpid()))
            time.sleep(600)
        return run.engine.t_end

    def kill():
        until(lambda: os.path.lexists(text))
        os.kill(int(str(Path(text).readlink())), signal.SIGKILL)

    options = {**ASKED, "over": {"drop_height": "0.3..0.5 m:21"}, "functions": {"waits": waits}, "compiled": False}
    made, client = two
    killer = threading.Thread(target=kill)
    killer.start()
    table = sweep("bouncing_ball", **options, client=client, out=tmp_path / "rows")
    killer.join()
    assert [process.poll() for process in made.processes].count(-signal.SIGKILL) == 1
    assert len(client.nthreads()) == 1
    made.add()
    client.wait_for_workers(2, timeout=240)
    assert table.counts() == {"finished": 21}
    assert same(table, sweep("bouncing_ball", **options))
    assert same(table, Sweep.load(tmp_path / "rows"))


@pytest.mark.exhaustive
def test_a_row_that_kills_its_workers_is_lost_alone(tmp_path):
    def dies(run):
        if abs(run.engine.initial["vertical.travel"] - 0.5) < 1e-9:
            os._exit(3)
        return run.engine.t_end

    options = {**ASKED, "over": {"drop_height": "0.3..0.5 m:21"}, "functions": {"dies": dies}, "compiled": False}
    with running(tmp_path, 3, DASK_DISTRIBUTED__SCHEDULER__ALLOWED_FAILURES="0") as (_, client):
        table = sweep("bouncing_ball", **options, client=client)
        assert len(client.nthreads()) == 1  # it killed one beside others, and one alone
    assert table.counts() == {"finished": 20, "lost": 1}
    assert "died" in table.rows[10].message


LONG = ["--over", "clearance=-2 mm, -1 mm, 0.4 mm, 0.5 mm"]
LONG += ["--duration", "1 h", "--tolerance", "1e-10", "--max-steps", "1000000000"]


@contextmanager
def begun(client, folder, tmp_path):
    """A process that has stored two rows, and has two that take minutes on the workers."""
    command = [str(Path(sys.executable).with_name("hertzwerk")), "sweep", "slider_crank", *LONG]
    address = ["--out", str(folder), "--cluster", client.scheduler.address]
    with (
        (tmp_path / "said").open("w") as said,
        subprocess.Popen([*command, *address], stdout=said, stderr=said) as parent,
    ):
        try:
            until(lambda: sum(key.startswith("_do") for keys in client.processing().values() for key in keys) == 2)
            until(lambda: all(client.run(lambda: cluster._one.locked()).values()))
            yield parent
        finally:
            parent.kill()


@pytest.mark.slow
@pytest.mark.parametrize("ending", [signal.SIGINT, pytest.param(signal.SIGKILL, marks=pytest.mark.exhaustive)])
def test_who_starts_it_and_ends_leaves_no_row_behind_on_a_worker(client, ending, tmp_path):
    with begun(client, tmp_path / "rows", tmp_path) as parent:
        parent.send_signal(ending)
        assert parent.wait(60) == (1 if ending == signal.SIGINT else -ending)
    assert list(Sweep.load(tmp_path / "rows")["outcome"]) == ["bad_input"] * 2
    if ending == signal.SIGINT:
        assert "interrupted" in (tmp_path / "said").read_text()
    until(
        lambda: not any(client.run(lambda: cluster._one.locked()).values()), patience=60
    )  # the rows would take minutes


@pytest.mark.exhaustive
def test_a_scheduler_that_dies_ends_it_and_the_rest_is_computed_elsewhere(tmp_path):
    def end(fraction):
        if fraction > 0.3:
            made.scheduler.kill()

    def slowly(run):
        time.sleep(0.1)
        return run.engine.t_end

    options = {**ASKED, "functions": {"end": slowly}, "compiled": False, "out": tmp_path / "rows"}
    with running(tmp_path, 1) as (made, client):
        table = sweep("bouncing_ball", **options, client=client, progress=end)
    assert table.outcome.name == "cluster_lost"
    assert "scheduler" in table.outcome.message
    assert "--resume" in table.outcome.remedy
    assert 4 <= len(table) < 12
    rest = sweep("bouncing_ball", **options, workers=1)
    assert rest.counts() == {"finished": 12}
    assert same(rest, sweep("bouncing_ball", **{**options, "out": None}))


@pytest.mark.exhaustive
def test_workers_that_are_all_gone_end_it(tmp_path, monkeypatch):
    def dies(run):
        os._exit(3)

    monkeypatch.setattr(cluster, "PATIENCE", 2.0)
    with running(tmp_path, 1) as (_, client):
        table = sweep("bouncing_ball", **ASKED, functions={"dies": dies}, compiled=False, client=client)
    assert (table.outcome.name, len(table)) == ("cluster_lost", 0)
    assert "no worker" in table.outcome.message
