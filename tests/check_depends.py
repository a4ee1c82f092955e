#!/usr/bin/env python3
"""Holds every #include "module/..." of lib/ and tools/ against lib/DEPENDS, and CLI11 to tools/ and lib/core/tool.cpp.

usage: check_depends.py TOP        TOP is the top level of the checkout
Prints one line per fault and exits 1 if there is any, or if there was nothing to check.
"""
import re
import sys
from pathlib import Path

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>)')


def allowed_modules(path):
    """DEPENDS as {module: modules that it may include}, and its faults: a module may name only those above it."""
    allowed, faults = {}, []
    for line in path.read_text().splitlines():
        if line.startswith("#") or not line.strip():
            continue
        module, _, names = line.partition(":")
        unknown = [name for name in names.split() if name not in allowed]
        if unknown:
            faults.append(f"{path}: {module} names {', '.join(unknown)}, which does not stand above it")
        allowed[module.strip()] = set(names.split()) | {module.strip()}
    return allowed, faults


def module_of(source, top):
    parts = source.relative_to(top).parts
    return "tools" if parts[0] == "tools" else parts[1]


def faults_of(source, top, allowed):
    module = module_of(source, top)
    if module not in allowed:
        yield f"{source}: module '{module}' is not in lib/DEPENDS"
        return
    takes_cli11 = module == "tools" or source.relative_to(top) == Path("lib/core/tool.cpp")
    for number, line in enumerate(source.read_text().splitlines(), start=1):
        match = INCLUDE.match(line)
        if not match:
            continue
        quoted, system = match.groups()
        if quoted and quoted.split("/")[0] not in allowed[module]:
            yield f"{source}:{number}: {module} may not include \"{quoted}\"; lib/DEPENDS allows {', '.join(sorted(allowed[module]))}"
        if quoted and not (top / "lib" / quoted).is_file():
            yield f"{source}:{number}: \"{quoted}\" is not a file of lib/; includes are written from there"
        if system and system.startswith("CLI/") and not takes_cli11:
            yield f"{source}:{number}: only tools/ and lib/core/tool.cpp include CLI11"


def main():
    top = Path(sys.argv[1])
    allowed, faults = allowed_modules(top / "lib/DEPENDS")
    sources = sorted(path for folder in ("lib", "tools") for path in (top / folder).rglob("*.[ch]pp"))
    if not sources:
        faults.append(f"{top}: no sources in lib/ or tools/")
    for source in sources:
        faults += faults_of(source, top, allowed)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
