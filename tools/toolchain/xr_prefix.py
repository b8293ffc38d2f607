# SPDX-License-Identifier: MIT
"""A private folder with an OpenXR runtime (Monado) and a software Vulkan, for tests and benchmarks.

Never made for users: whoever has a headset has its runtime and a graphics card's driver.
"""

from __future__ import annotations

import json
import subprocess
from pathlib import Path
from typing import ClassVar

from .apt import SUITE
from .console import Failure
from .prefix import LIBRARIES, Prefix

LAYOUT = 1  # Raised when the way the folder is made changes.
PARTS = (".", "..", "lapack", "blas", "pulseaudio")


class XrPrefix(Prefix):
    """The folder: monado-service in `bin/`, manifests of runtime and driver beside it."""

    name = f"xr-{SUITE}-{LAYOUT}"
    packages: ClassVar[list[str]] = [
        "monado-service",
        "libopenxr1-monado",
        "libvulkan1",
        "mesa-vulkan-drivers",
        "patchelf",
    ]
    programs: ClassVar[list[str]] = ["monado-service"]
    what = "Monado and a software Vulkan"
    download_mb = 110
    unpacked_mb = 600
    absent = "Tests of the headset need Monado"
    remedy = "leave the tests of the headset out"

    @property
    def runtime(self) -> Path:
        """The manifest for XR_RUNTIME_JSON."""
        return self.folder / "openxr_monado.json"

    @property
    def driver(self) -> Path:
        """The manifest for VK_DRIVER_FILES: lavapipe."""
        return self.folder / "lvp_icd.json"

    @staticmethod
    def _search_path(there: Path) -> str:
        # Only the alternatives of an installed Debian put lapack and blas beside the others.
        return ":".join(str(there / part) for part in PARTS)

    def _finish(self, work: Path) -> None:
        self._patch_library(work, "libopenxr_monado.so")
        self._patch_library(work, "libvulkan_lvp.so")
        self._patch_library(work, "libvulkan.so.1")
        there = self.root / LIBRARIES
        runtime = {"name": "Monado", "library_path": str(there / "libopenxr_monado.so")}
        manifest = {"file_format_version": "1.0.0", "runtime": runtime}
        (work / self.runtime.name).write_text(json.dumps(manifest), encoding="utf-8")
        listed = sorted((work / "root/usr/share/vulkan/icd.d").glob("lvp_icd*.json"))
        if not listed:
            raise Failure("mesa-vulkan-drivers holds no lavapipe: its layout has changed.")
        driver = json.loads(listed[0].read_text(encoding="utf-8"))
        driver["ICD"]["library_path"] = str(there / "libvulkan_lvp.so")
        (work / self.driver.name).write_text(json.dumps(driver), encoding="utf-8")

    def _patch_library(self, work: Path, name: str) -> None:
        """Lets a library that another program loads find the libraries beside it."""
        here = work / "root" / LIBRARIES
        found = [*here.rglob(name), *(work / "root/usr/lib").glob(name)]
        if not found:
            raise Failure(f"{name} is not where it was: the packages of Debian {SUITE} changed.")
        rpath = self._search_path(self.root / LIBRARIES)
        edit = [*self._editor(work), "--force-rpath", "--set-rpath", rpath]
        subprocess.run([*edit, str(found[0].resolve())], check=True)
