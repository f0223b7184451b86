"""Processes that sleep while a GPU works for them."""

from __future__ import annotations

import ctypes
from typing import Any

import pytest

from esg.machine.waiting import sleep_for_gpus

BLOCKING_SYNC = 4  # CU_CTX_SCHED_BLOCKING_SYNC


class Driver:
    """Stands for CUDA's library on a machine with some GPUs, of which one refuses."""

    def __init__(self, gpus: int, refuses: int = -1) -> None:
        self.gpus, self.refuses = gpus, refuses
        self.told: list[tuple[int, int]] = []
        self.begun = False

    def cuInit(self, flags: int) -> int:
        self.begun = True
        return 0

    def cuDeviceGetCount(self, count: Any) -> int:
        count._obj.value = self.gpus
        return 0

    def cuDevicePrimaryCtxSetFlags_v2(self, gpu: int, flags: int) -> int:
        assert self.begun
        self.told.append((gpu, flags))
        return 1 if gpu == self.refuses else 0


def test_every_gpu_is_told(monkeypatch: pytest.MonkeyPatch) -> None:
    driver = Driver(3, refuses=1)
    monkeypatch.setattr(ctypes, "CDLL", lambda name: driver)
    assert sleep_for_gpus() == 2
    assert driver.told == [(k, BLOCKING_SYNC) for k in range(3)]


def test_a_machine_without_a_driver_is_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    def missing(name: str) -> None:
        raise OSError(f"{name}: cannot open shared object file")

    monkeypatch.setattr(ctypes, "CDLL", missing)
    assert sleep_for_gpus() == 0
