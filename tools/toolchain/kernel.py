# SPDX-License-Identifier: MIT
"""A virtual machine with a stock Debian kernel, for tests with its own USB drivers. No root.

QEMU is the machine's own where it has one, else Debian's in a private folder; Debian's kernel.
The machine has no disk: all that it needs is in an initial file system that is made here.
"""

from __future__ import annotations

import lzma
import os
import re
import select
import shutil
import subprocess
import time
from pathlib import Path

from .apt import KEYRING, AptError, apt_command, apt_run, mirrors
from .console import Failure, step, tail
from .paths import BUILD, cache, lock, make_folder, need_space
from .project import EXTENSIONS
from .usb import LIBRARIES, OLDER_SUITES, suites

LAYOUT = 1  # Raised when the way the folder is made changes.
MODULES = ["vhci-hcd", "ftdi_sio", "xsens_mt"]
PROGRAMS = {"init": "suit_kernel_init", "bin/suit_stream": "suit_stream"}
BASE_PACKAGES = ("libc6_", "libgcc-s1_", "gcc-")
MEMORY_MB = 512
# Within which a machine that works has begun to speak.
FIRST_WORD_S = 20.0


class KernelMachine:
    """The virtual machine: its folder in the cache, and how it is run."""

    def __init__(self) -> None:
        self.suite = suites()[0]
        self.folder = cache() / f"kernel-{self.suite}-{LAYOUT}"
        self.root = self.folder / "root"

    def run(self, limit_s: float) -> str:
        """Starts the machine and returns what its console has shown when it is off again."""
        self.ensure()
        work = make_folder(BUILD / "kernel")
        image = work / "initramfs"
        image.write_bytes(self._initial_files())
        kernel = next(iter(sorted((self.root / "boot").glob("vmlinuz-*"))))
        command = ["-m", str(MEMORY_MB), "-smp", "2", "-no-reboot", "-nographic"]
        command += ["-nodefaults", "-serial", "stdio", "-kernel", str(kernel)]
        command += ["-initrd", str(image), "-append", "console=ttyS0 quiet panic=-1 rdinit=/init"]
        text = ""
        if os.access("/dev/kvm", os.R_OK | os.W_OK):
            # A machine inside another may say that it has KVM, and then fail or stand still.
            text = _start([*self._qemu(), "-accel", "kvm", *command], limit_s, FIRST_WORD_S)
        if "RESULT" not in text:
            text = _start([*self._qemu(), "-accel", "tcg", *command], limit_s, limit_s)
        (work / "console.log").write_text(text, encoding="utf-8")
        return text

    def _qemu(self) -> list[str]:
        """How to start QEMU: the machine's own, or the folder's with its libraries and data."""
        own = shutil.which("qemu-system-x86_64")
        if own is not None:
            return [own]
        libraries = self.root / LIBRARIES
        # Of the host's own release: the host's loader can start it.
        data = [str(self.root / "usr/share" / name) for name in ("qemu", "seabios")]
        paths = f"LD_LIBRARY_PATH={libraries}:{self.root / 'lib' / LIBRARIES.name}"
        program = str(self.root / "usr/bin/qemu-system-x86_64")
        return ["env", paths, program, "-L", data[0], "-L", data[1]]

    def ensure(self) -> None:
        """Makes the folder once for all clones; an interrupted attempt leaves nothing."""
        if self.folder.exists():
            return
        missing = [tool for tool in ("apt-get", "dpkg") if shutil.which(tool) is None]
        if missing or not KEYRING.exists():
            what = ", ".join(missing) or str(KEYRING)
            raise Failure(f"The kernel for the test cannot be fetched without {what}.")
        with lock(cache() / "kernel.lock", "setting up the kernel for tests"):
            if self.folder.exists():
                return
            need_space(cache(), 1200, "a kernel and QEMU")
            work = self.folder.with_name(self.folder.name + ".part")
            shutil.rmtree(work, ignore_errors=True)
            self._download(work)
            shutil.rmtree(work / "apt", ignore_errors=True)
            shutil.rmtree(work / "archives", ignore_errors=True)
            work.rename(self.folder)

    def _download(self, work: Path) -> None:
        failure = "apt names no mirror"
        for suite in dict.fromkeys([self.suite, *OLDER_SUITES]):
            for site in mirrors():
                apt = apt_command(work, site, "deb", suite)
                try:
                    with step(f"download Debian {suite}'s kernel and QEMU (about 130 MB)"):
                        apt_run([*apt, "update"])
                        archives = _fetch(apt, work)
                except AptError as error:
                    failure = (str(error).strip().splitlines() or [failure])[-1]
                    shutil.rmtree(work, ignore_errors=True)
                    continue
                with step(f"unpack {len(archives)} packages"):
                    for archive in archives:
                        _call(["dpkg", "-x", str(archive), str(work / "root")])
                return
        raise Failure(
            f"Debian's kernel and QEMU cannot be had ({failure}): check the network, or set "
            "DISMOUNT_DEBIAN_MIRROR to a Debian mirror."
        )

    def _initial_files(self) -> bytes:
        """The machine's files: our programs, their libraries, the kernel's modules."""
        files: dict[str, bytes] = {}
        for target, name in PROGRAMS.items():
            program = EXTENSIONS / "xbus" / name
            if not program.exists():
                raise Failure(f"{program} has not been built: it needs libusb.")
            files[target] = program.read_bytes()
            for library, source in _libraries(program).items():
                files[library] = source.read_bytes()
        order: list[str] = []
        for module in MODULES:
            self._add_module(module, files, order)
        files["modules/order"] = "".join(f"{name}\n" for name in order).encode()
        return _archive(files)

    def _add_module(self, name: str, files: dict[str, bytes], order: list[str]) -> None:
        wanted = name.replace("-", "_")
        for path in (self.root / "lib" / "modules").rglob("*.ko*"):
            if path.name.split(".")[0].replace("-", "_") != wanted:
                continue
            data = path.read_bytes()
            data = lzma.decompress(data) if path.suffix == ".xz" else data
            needs = re.search(rb"\0depends=([^\0]*)\0", data)
            for other in needs.group(1).decode().split(",") if needs else []:
                if other and f"{other}.ko" not in order:
                    self._add_module(other, files, order)
            if f"{wanted}.ko" not in order:
                files[f"modules/{wanted}.ko"] = data
                order.append(f"{wanted}.ko")
            return
        # What is not there is built into the kernel.


def _start(command: list[str], limit_s: float, first_word_s: float) -> str:
    """Runs the machine until it is off, or for so long; ends it where it does not begin in time."""
    begin = time.monotonic()
    text = b""
    with subprocess.Popen(
        command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT
    ) as process:
        assert process.stdout is not None
        while True:
            passed = time.monotonic() - begin
            limit = limit_s if b"RESULT" in text else min(first_word_s, limit_s)
            if passed > limit:
                process.kill()
                text += f"\nended after {passed:.0f} s\n".encode()
                break
            if select.select([process.stdout], [], [], 1.0)[0]:
                more = os.read(process.stdout.fileno(), 65536)
                if not more:
                    break
                text += more
    return text.decode(errors="replace")


def _fetch(apt: list[str], work: Path) -> list[Path]:
    command = [*apt, "-y", "--no-install-recommends", "--print-uris", "install"]
    needed = [] if shutil.which("qemu-system-x86_64") else ["qemu-system-x86"]
    names: list[str] = []
    if needed:
        done = subprocess.run([*command, *needed], capture_output=True, text=True, check=False)
        lines = [line.split()[1] for line in done.stdout.splitlines() if line.startswith("'")]
        names = [name.split("_")[0] for name in lines if not name.startswith(BASE_PACKAGES)]
    cached = ["apt-cache", *apt[2:], "depends", "linux-image-amd64"]
    done = subprocess.run(cached, capture_output=True, text=True, check=False)
    kernel = re.search(r"Depends: (linux-image-[\w.+-]+)", done.stdout)
    if kernel is None or (needed and not names):
        raise AptError(done.stderr or "it has no kernel or no QEMU")
    folder = make_folder(work / "archives")
    apt_run([*apt, "download", *names, kernel.group(1)], folder)
    return sorted(folder.glob("*.deb"))


def _call(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failure(f"{' '.join(command[:2])} failed.\n{tail(done.stderr, 3)}")


def _libraries(program: Path) -> dict[str, Path]:
    """What a program loads, by where the machine will have it."""
    text = subprocess.run(["ldd", str(program)], capture_output=True, text=True, check=True).stdout
    found: dict[str, Path] = {}
    for name, path in re.findall(r"^\s*(\S+) => (/\S+)", text, re.M):
        found[f"lib/{name}"] = Path(path)
    for path in re.findall(r"^\s*(/\S+) \(0x", text, re.M):
        found[path.lstrip("/")] = Path(path)
    return found


def _archive(files: dict[str, bytes]) -> bytes:
    """A cpio archive ("newc"), as kernels take it for their first file system."""
    entries: list[tuple[str, int, bytes]] = []
    folders: set[str] = {"dev"}
    for name in files:
        folders.update(str(parent) for parent in Path(name).parents if str(parent) != ".")
    entries += [(folder, 0o040755, b"") for folder in sorted(folders)]
    entries += [(name, 0o100755, data) for name, data in sorted(files.items())]
    entries.append(("TRAILER!!!", 0, b""))
    archive = bytearray()
    for number, (name, mode, data) in enumerate(entries, 1):
        fields = [number, mode, 0, 0, 1, 0, len(data), 0, 0, 0, 0, len(name) + 1, 0]
        archive += b"070701" + b"".join(b"%08X" % field for field in fields)
        archive += name.encode() + b"\0"
        archive += bytes(-len(archive) % 4)
        archive += data
        archive += bytes(-len(archive) % 4)
    return bytes(archive)
