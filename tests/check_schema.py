#!/usr/bin/env python3
"""Holds a file that a tool reads or writes against its description in data-schemas/.

usage: check_schema.py data-schemas/NAME.json FILE

A description is one of three:
- a JSON Schema (it has "$schema"): FILE is TOML or GeoJSON, held against it by python3-jsonschema.
- "kind": "tsv": {"schema": "slidezone-row 1", "kind": "tsv", "meaning": ..., "columns": [COLUMN, ...]} where COLUMN is
  {"name", "type", "meaning"} and perhaps "unit", "choices" (of type choice) and "missing" (a word that stands for a number that does
  not exist, "nan" or "unbounded", or a list of both). A name may end in "<unit>", which stands for any word. Types: whole (>= 0), real (finite), text (not empty), choice. Columns stand in this
  order and there are no others. Lines "# key: value" come before the header row, "# schema:" first; "provenance": "optional" in the
  description lets a table of the user's do without. Several tables in a row are one table.
- "kind": "hdf5": {"schema", "kind", "meaning", "attributes": [{"name", "type", "meaning"}], "datasets": [{"path", "type", "shape",
  "meaning"}]}. Types: real (float64), whole (int64), byte (uint8), text. A shape lists lengths and names; one name is one length
  throughout the file, but one that begins with "own" is each dataset's own. An attribute belongs to the root, or to the object that its "path" names. A path may end in "<name>", which
  stands for one or more objects that no other entry lists; so may the name of an attribute that may be absent. "optional": true allows an entry to be absent. Nothing else may be there.

Prints one line per fault and exits 1 if there is any, 2 if the description itself is wrong.
"""
import json
import math
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import jsonschema

KEYS = {
    "tsv": {"schema", "kind", "meaning", "columns", "provenance"},
    "hdf5": {"schema", "kind", "meaning", "attributes", "datasets"},
    "column": {"name", "type", "unit", "choices", "missing", "meaning"},
    "attribute": {"name", "type", "unit", "path", "shape", "choices", "optional", "meaning"},
    "dataset": {"path", "type", "unit", "shape", "optional", "meaning"},
}
TYPES = {
    "column": {"whole", "real", "text", "choice"},
    "attribute": {"whole", "real", "text"},
    "dataset": {"whole", "real", "byte"},
}


def stop(message):
    print(message)
    sys.exit(2)


def check_description(description, name):
    """A misspelt key would quietly check nothing."""
    kind = description.get("kind")
    if kind not in ("tsv", "hdf5"):
        stop(f"{name}: kind is {kind!r}, expected tsv or hdf5")
    entries = [(kind, description)]
    for list_name in ("columns", "attributes", "datasets"):
        entries += [(list_name[:-1], entry) for entry in description.get(list_name, [])]
    for entry_kind, entry in entries:
        unknown = entry.keys() - KEYS[entry_kind]
        if unknown or "meaning" not in entry and entry_kind not in ("tsv", "hdf5"):
            stop(f"{name}: {entry} has unknown keys {sorted(unknown)} or no meaning")
        if entry_kind in TYPES and entry.get("type") not in TYPES[entry_kind]:
            stop(f"{name}: {entry} has no type of {sorted(TYPES[entry_kind])}")


# ---- TOML and GeoJSON ------------------------------------------------------------------------------------------------------


def document_faults(schema, path):
    jsonschema.Draft202012Validator.check_schema(schema)
    parse = json.loads if path.suffix == ".geojson" else tomllib.loads
    for error in jsonschema.Draft202012Validator(schema).iter_errors(parse(path.read_text())):
        yield f"{path}: {error.json_path}: {error.message}"


# ---- TSV -------------------------------------------------------------------------------------------------------------------

WHOLE = re.compile(r"0|[1-9][0-9]*")
REAL = re.compile(r"-?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?")


def is_of_type(text, column):
    missing = column.get("missing", [])
    if text in ([missing] if isinstance(missing, str) else missing):
        return True
    if column["type"] == "whole":
        return WHOLE.fullmatch(text) is not None
    if column["type"] == "real":
        return REAL.fullmatch(text) is not None and math.isfinite(float(text))
    if column["type"] == "choice":
        return text in column["choices"]
    return text.strip() != ""


def row_faults(columns, fields, place):
    if len(fields) != len(columns):
        yield f"{place}: {len(fields)} fields, expected {len(columns)}"
    for column, text in zip(columns, fields):
        if not is_of_type(text, column):
            yield f"{place}: {column['name']} is '{text}', expected {column.get('choices', column['type'])}"


def tsv_faults(description, path):
    columns = description["columns"]
    header = [column["name"] for column in columns]
    is_header = re.compile("\t".join(re.escape(name.split("<")[0]) + ("\\S+" if "<" in name else "") for name in header)).fullmatch
    text = path.read_bytes().decode()
    if not text.endswith("\n"):
        yield f"{path}: the last line has no end"
    lines = text.splitlines()
    if description.get("provenance") != "optional":
        for line, expected in zip(lines, ("# schema: " + description["schema"], "# tool: ")):
            if not line.startswith(expected):
                yield f"{path}: found '{line}', expected '{expected}...'"
    headers = 0
    for number, line in enumerate(lines, start=1):
        place = f"{path}:{number}"
        if line.startswith("#"):
            if not re.fullmatch(r"# [^:]+: .+", line) and description.get("provenance") != "optional":
                yield f"{place}: found '{line}', expected '# key: value'"
        elif is_header(line):
            headers += 1
        elif headers == 0:
            yield f"{place}: found the header {line.split(chr(9))}, expected {header}"
            return
        else:
            yield from row_faults(columns, line.split("\t"), place)
    if headers == 0:
        yield f"{path}: no header row"


# ---- HDF5, seen through h5dump ---------------------------------------------------------------------------------------------

NAMESPACE = {"h": "http://hdfgroup.org/HDF5/XML/schema/HDF5-File.xsd"}
TYPE_NAMES = {("FloatType", "8", None): "real", ("IntegerType", "8", "true"): "whole", ("IntegerType", "1", "false"): "byte"}


def type_of(node):
    atom = node.find("h:DataType/h:AtomicType/*", NAMESPACE)
    if atom is None:
        return "compound"
    kind = atom.tag.split("}")[1]
    return "text" if kind == "StringType" else TYPE_NAMES.get((kind, atom.get("Size"), atom.get("Sign")), kind + str(atom.attrib))


def shape_of(node):
    return [int(length.get("DimSize")) for length in node.findall("h:Dataspace/h:SimpleDataspace/h:Dimension", NAMESPACE)]


def contents(path):
    """{path: (type, shape)} of the datasets and {(owner, name): (type, shape, value as text)} of the attributes."""
    xml = subprocess.run(["h5dump", "--onlyattr", "--xml", str(path)], capture_output=True, check=False)
    if xml.returncode != 0:
        return None, None
    datasets, attributes = {}, {}
    for node in ElementTree.fromstring(xml.stdout).iter():
        owner = node.get("H5Path")
        if owner is None:
            continue
        if node.tag.endswith("}Dataset"):
            datasets[owner] = (type_of(node), shape_of(node))
        for item in node.findall("h:Attribute", NAMESPACE):
            value = item.findtext("h:Data/h:DataFromFile", "", NAMESPACE).strip()
            attributes[(owner, item.get("Name"))] = (type_of(item), shape_of(item), value)
    return datasets, attributes


def matches(pattern, paths, listed):
    """Paths that an entry describes: itself, or all that its "<name>" can stand for."""
    if "<" not in pattern:
        return [path for path in paths if path == pattern]
    wanted = re.compile(re.escape(pattern[: pattern.index("<")]) + "[^/]+")
    return [path for path in paths if wanted.fullmatch(path) and path not in listed]


def type_and_shape_faults(entry, found_type, found_shape, lengths, what):
    if found_type != entry["type"]:
        yield f"{what} is of type {found_type}, expected {entry['type']}"
    expected = entry.get("shape", [])
    if len(found_shape) != len(expected):
        yield f"{what} has shape {found_shape}, expected {expected}"
        return
    for length, name in zip(found_shape, expected):
        if str(name).startswith("own "):
            continue
        known = name if isinstance(name, int) else lengths.setdefault(name, length)
        if length != known:
            yield f"{what} has shape {found_shape}, expected {expected} with {name} = {known}"


def dataset_faults(description, datasets, lengths):
    listed = {entry["path"] for entry in description["datasets"]}
    described = set()
    for entry in description["datasets"]:
        found = matches(entry["path"], datasets, listed)
        described.update(found)
        if not found and not entry.get("optional"):
            yield f"no dataset {entry['path']}"
        for path in found:
            yield from type_and_shape_faults(entry, *datasets[path], lengths, path)
    for path in datasets.keys() - described:
        yield f"dataset {path} is not in the description"


def attribute_faults(description, attributes, datasets, lengths):
    listed = {entry["path"] for entry in description["datasets"]}
    described = {("/", "schema"), ("/", "tool")}
    for key in described - attributes.keys():
        yield f"no attribute {key[1]}"
    if attributes.get(("/", "schema"), ("", [], ""))[2] != f'"{description["schema"]}"':
        yield f"schema is {attributes.get(('/', 'schema'))}, expected {description['schema']}"
    for entry in description["attributes"]:
        pattern = entry.get("path", "/")
        if "<" in entry["name"]:
            described.update(key for key in attributes if key[0] == pattern and key[1].startswith(entry["name"].split("<")[0]))
            continue
        owners = matches(pattern, datasets, listed) if "<" in pattern else [pattern]
        for key in [(owner, entry["name"]) for owner in owners]:
            described.add(key)
            if key not in attributes:
                if not entry.get("optional"):
                    yield f"no attribute {key[1]} of {key[0]}"
                continue
            found_type, found_shape, value = attributes[key]
            yield from type_and_shape_faults(entry, found_type, found_shape, lengths, f"attribute {key[1]} of {key[0]}")
            if "choices" in entry and value.strip('"') not in entry["choices"]:
                yield f"attribute {key[1]} of {key[0]} is {value}, expected one of {entry['choices']}"
    for owner, name in attributes.keys() - described:
        yield f"attribute {name} of {owner} is not in the description"


def hdf5_faults(description, path):
    datasets, attributes = contents(path)
    if datasets is None:
        yield f"{path}: h5dump cannot read it"
        return
    lengths = {}
    for fault in dataset_faults(description, datasets, lengths):
        yield f"{path}: {fault}"
    for fault in attribute_faults(description, attributes, datasets, lengths):
        yield f"{path}: {fault}"


# ---- the command -----------------------------------------------------------------------------------------------------------


def faults_of(description, path):
    if "$schema" in description:
        return document_faults(description, path)
    return {"tsv": tsv_faults, "hdf5": hdf5_faults}[description["kind"]](description, path)


def main():
    if len(sys.argv) != 3:
        stop(__doc__)
    description_path, path = Path(sys.argv[1]), Path(sys.argv[2])
    description = json.loads(description_path.read_text())
    if "$schema" not in description:
        check_description(description, description_path)
    faults = list(faults_of(description, path))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
