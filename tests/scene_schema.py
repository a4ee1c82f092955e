#!/usr/bin/env python3
"""Holds data-schemas/scene.schema.json and the reader of scenes against each other.

usage: scene_schema.py good|bad|rules|agree READ_SCENE

good   every scene in pipelines/ and tests/scenes/ passes both; those in tests/scenes/ use every key of the schema
bad    every scene of BAD is refused by both at the right place with the right words, every one of READER_ALONE by the reader
rules  every rule of the schema refuses some scene of BAD
agree  whatever single value is replaced or line removed in a good scene: what the schema refuses, the reader refuses

READ_SCENE is the program made of tests/read_scene.cpp. The schema is applied by python3-jsonschema. Prints one line per fault
and exits 1 if there is any.
"""
import json
import re
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

import jsonschema

TOP = Path(__file__).resolve().parent.parent
# A key that must not stand has the schema false; "not anything" says the same and is an object with an identity of its own.
SCHEMA = json.loads((TOP / "data-schemas/scene.schema.json").read_text(), object_hook=lambda item: {
    key: {"not": {}} if value is False and key != "additionalProperties" else value for key, value in item.items()})
VALIDATOR = jsonschema.Draft202012Validator(SCHEMA)
SCENES = {path.stem: path.read_text() for path in sorted((TOP / "tests/scenes").glob("*.toml"))}

# A bad scene is a good one with a change: (name in tests/scenes/, old text, new text, words of the message). The old text stands
# once in the scene; it may be a regular expression. "@" in the new text marks the place that the message names, and is taken out.
# Without a mark that is the head of the table which was changed or, where a whole table is gone, the beginning of the file.
TWO_SOILS = re.compile(r"(\[slope\].*?)\[\[soil\]\].*(\[base\].*)", re.S)
CUT_SLOPE = 'height = "4 m"\nlength = "8 m"\nangle = "90 deg"'
BAD = [
    ("cut", "[slope]", "@colour = 1\n[slope]", "unknown key 'colour' in a scene; expected title, slope, grid"),
    ("cut", "[gravity]", "[@gravty]", "unknown key 'gravty' in a scene; did you mean 'gravity'?"),
    ("layers", '"Two layers and a berm"', "@3", "'title' wants a text in quotes, found 3"),
    # [slope]
    ("cut", "[slope]\n" + CUT_SLOPE, "", "no table [slope] in the scene"),
    ("cut", "[slope]\n" + CUT_SLOPE, "slope = @5", "'slope' wants a table, found 5; write [slope]"),
    ("cut", 'height = "4 m"', '@hieght = "4 m"', "unknown key 'hieght' in [slope]; did you mean 'height'?"),
    ("cut", 'height = "4 m"\n', "", "no key 'height' in [slope]"),
    ("cut", 'length = "8 m"\n', "", "no key 'length' in [slope]"),
    ("cut", 'angle = "90 deg"', "", "no key 'angle' in [slope]"),
    ("cut", '"4 m"', "@4", "'height' wants a text with its unit, found 4; write e.g. \"5 m\""),
    ("cut", '"4 m"', '@"4"', "'height' wants a length, found \"4\""),
    ("cut", '"4 m"', '@"four m"', "'height' wants a length, found \"four m\""),
    ("cut", '"4 m"', '@"0 m"', "'height' wants above 0 m, found \"0 m\""),
    ("cut", '"8 m"', '@"-8 m"', "'length' wants above 0 m, found \"-8 m\""),
    ("cut", '"90 deg"', '@"0 deg"', "'angle' wants above 0 and at most 90 deg, found \"0 deg\""),
    ("layers", "[slope]", '[slope]\nheight = @"5 m"', "'height' cannot stand beside 'surface'; give either"),
    ("layers", "[slope]", '[slope]\nlength = @"5 m"', "'length' cannot stand beside 'surface'; give either"),
    ("layers", "[slope]", '[slope]\nangle = @"5 deg"', "'angle' cannot stand beside 'surface'; give either"),
    ("cut", CUT_SLOPE, 'surface = @"4 m"', "'surface' wants a list of at least 2 points"),
    ("cut", CUT_SLOPE, 'surface = @[["0 m", "4 m"]]', "'surface' wants a list of at least 2 points"),
    ("layers", '["10 m", "5 m"]', '@"10 m"', "'surface' wants points of two coordinates like [\"0 m\", \"5 m\"], found \"10 m\""),
    ("layers", '["10 m", "5 m"]', '@["10 m"]', "'surface' wants points of two coordinates"),
    ("layers", '["10 m", "5 m"]', '@["10 m", "5 m", "1 m"]', "'surface' wants points of two coordinates"),
    ("layers", '["10 m", "5 m"]', '[@10, "5 m"]', "'surface' wants a text with its unit, found 10"),
    ("layers", '["10 m", "5 m"]', '@["10 m", "-5 m"]', "'surface' wants elevations of at least 0 m, found (10 m, -5 m)"),
    # [grid]
    ("cut", re.compile(r"\[grid\].*?(?=\[\[)", re.S), "@[[grid]]\n", "'grid' wants a table, found a list; write [grid]"),
    ("cut", "points_per_cell = 2", "@points = 2", "unknown key 'points' in [grid]; expected cell, width, height or points_per_cell"),
    ("cut", 'cell = "0.5 m"\n', "", "no key 'cell' in [grid]"),
    ("cut", 'width = "16 m"\n', "", "no key 'width' in [grid]"),
    ("cut", 'height = "5 m"\n', "", "no key 'height' in [grid]"),
    ("layers", '["0.5 m", "25 cm"]', '@["0.5 m"]', "'cell' wants \"5 m\" or [\"5 m\", \"5 m\"] (x, y), found a list of 1"),
    ("layers", '["0.5 m", "25 cm"]', '@["0.5 m", "25 cm", "1 m"]', "'cell' wants \"5 m\" or [\"5 m\", \"5 m\"] (x, y), found a list of 3"),
    ("layers", '["0.5 m", "25 cm"]', '["0.5 m", @"0 cm"]', "'cell' wants above 0 m, found \"0 cm\""),
    ("cut", "points_per_cell = 2", "points_per_cell = @0", "'points_per_cell' wants a whole number from 1 to 8, found 0"),
    ("cut", "points_per_cell = 2", "points_per_cell = @9", "'points_per_cell' wants a whole number from 1 to 8, found 9"),
    ("cut", "points_per_cell = 2", "points_per_cell = @1.5", "'points_per_cell' wants a whole number from 1 to 8, found 1.5"),
    # [[soil]]
    ("cut", TWO_SOILS, r"soil = @5\n\1\2", "'soil' wants one or several tables, found 5; write [[soil]]"),
    ("cut", TWO_SOILS, r"soil = @[]\n\1\2", "'soil' wants one or several tables, found a list"),
    ("cut", TWO_SOILS, r"soil = @[5]\n\1\2", "'soil' wants one or several tables, found a list"),
    ("cut", 'name = "silt"', '@nom = "silt"', "unknown key 'nom' in [soil]; did you mean 'name'?"),
    ("cut", 'name = "silt"\n', "", "no key 'name' in [soil]"),
    ("cut", '"silt"', "@1", "'name' wants a text in quotes, found 1"),
    ("cut", '"silt"', '@""', "'name' wants at least one letter"),
    ("cut", 'density = "1.9 t/m^3"\n', "", "no key 'unit_weight' in [soil]"),
    ("cut", '"1.9 t/m^3"', '@"1.9 t/m^3"\nunit_weight = "19 kN/m^3"', "'density' cannot stand beside 'unit_weight'; give either"),
    ("cut", '"1.9 t/m^3"', '@"0 t/m^3"', "'density' wants above 0 kg m-3, found \"0 t/m^3\""),
    ("cut", '"19 kN/m^3"', '@"-19 kN/m^3"', "'unit_weight' wants above 0 N m-3"),
    ("cut", 'youngs_modulus = "20 MPa"\n', "", "no key 'youngs_modulus' in [soil]"),
    ("cut", '"20 MPa"', '@"0 MPa"', "'youngs_modulus' wants above 0 Pa"),
    ("cut", "poisson_ratio = 0.3\n", "", "no key 'poisson_ratio' in [soil]"),
    ("cut", "poisson_ratio = 0.3\n", "poisson_ratio = @0.5\n", "'poisson_ratio' wants a number at least 0 and below 0.5, found 0.5"),
    ("cut", "poisson_ratio = 0.3\n", "poisson_ratio = @-0.1\n", "'poisson_ratio' wants a number at least 0 and below 0.5, found -0.1"),
    ("cut", "poisson_ratio = 0.3\n", 'poisson_ratio = @"0.3"\n', "'poisson_ratio' wants a number without unit, found \"0.3\""),
    ("cut", 'cohesion = "10 kPa"\n', "", "no key 'cohesion' in [soil]"),
    ("cut", '"10 kPa"', '@"-10 kPa"', "'cohesion' wants at least 0 Pa"),
    ("cut", '"35 deg"', '@"-35 deg"', "'friction_angle' wants at least 0 and below 90 deg, found \"-35 deg\""),
    ("layers", "softening_threshold = 0.05", "softening_threshold = @-0.05", "'softening_threshold' wants a number at least 0"),
    ("layers", "softening_threshold = 0.05", "softening_threshold = @true", "'softening_threshold' wants a number without unit, found true"),
    ("cut", '"10 kPa"', '"10 kPa"\nsoftening_shape = @-1', "'softening_shape' wants a number at least 0, found -1"),
    ("cut", '"10 kPa"', '"10 kPa"\nsoftening_shape = @"8"', "'softening_shape' wants a number without unit, found \"8\""),
    ("cut", '"10 kPa"', '"10 kPa"\ntop = @"3 m"', "'top' has no place in the first soil, which begins at the ground surface"),
    ("cut", 'top = "1 m"\n', "", "no key 'top' in [soil]"),
    ("cut", '"1 m"', '@"0 m"', "'top' wants above 0 m, found \"0 m\""),
    ("cut", '"1 m"', "@1", "'top' wants a text with its unit, found 1; write e.g. \"5 m\""),
    ("layers", '[["0 m", "2.5 m"], ["14 m", "1 m"]]', '@[["0 m", "2.5 m"]]', "'top' wants a list of at least 2 points"),
    # [base] and [walls]
    ("cut", re.compile(r'\[base\].*?(?=\[)', re.S), "@[[base]]\n", "'base' wants a table, found a list; write [base]"),
    ("cut", 'contact = "stick"', '@contract = "stick"', "unknown key 'contract' in [base]; did you mean 'contact'?"),
    ("cut", '"stick"', '@"stuck"', "'contact' wants bilateral, unilateral, stick or two-body, found \"stuck\"; did you mean 'stick'?"),
    ("cut", '"stick"', '"stick"\nfriction = @0.3', "'friction' has no place where the contact is \"stick\", which never slides"),
    ("layers", "friction = 0.3\n", "", "no key 'friction' in [base]"),
    ("layers", "friction = 0.3\n", "friction = @-0.3\n", "'friction' wants a number at least 0, found -0.3"),
    ("layers", "friction = 0.3\n", 'friction = @"30 deg"\n', "'friction' wants a number without unit, found \"30 deg\""),
    ("cut", re.compile(r'\[walls\].*?(?=\[)', re.S), "@[[walls]]\n", "'walls' wants a table, found a list; write [walls]"),
    ("cut", 'right = "open"', '@rigth = "open"', "unknown key 'rigth' in [walls]; did you mean 'right'?"),
    ("cut", '"roller"', '@"rollr"', "'left' wants roller, stick, open or symmetry, found \"rollr\"; did you mean 'roller'?"),
    ("cut", '"open"', '@"shut"', "'right' wants roller, stick, open or symmetry, found \"shut\""),
    # [gravity]
    ("cut", re.compile(r'\[gravity\].*?(?=\[)', re.S), "@[[gravity]]\n", "'gravity' wants a table, found a list; write [gravity]"),
    ("cut", 'protocol = "k0"', '@protocoll = "k0"', "unknown key 'protocoll' in [gravity]; did you mean 'protocol'?"),
    ("cut", '"k0"', '@"at once"', "'protocol' wants sudden, ramp or k0, found \"at once\""),
    ("cut", "k0 = 0.5", 'k0 = 0.5\nacceleration = @"0 m/s^2"', "'acceleration' wants above 0 m s-2"),
    ("cut", "k0 = 0.5", "k0 = @-0.5", "'k0' wants a number at least 0, found -0.5"),
    ("cut", "k0 = 0.5", 'k0 = @"0.5"', "'k0' wants a number without unit, found \"0.5\""),
    ("cut", "k0 = 0.5", 'ramp_time = @"2 s"', "'ramp_time' has a meaning only with protocol = \"ramp\""),
    ("layers", 'ramp_time = "2 s"', "k0 = @0.5", "'k0' has a meaning only with protocol = \"k0\""),
    ("layers", '"2 s"', '@"0 s"', "'ramp_time' wants above 0 s"),
    ("layers", '"3 deg"', '@"-3 deg"', "'tilt' wants at least 0 and below 90 deg, found \"-3 deg\""),
    # [initial]
    ("layers", re.compile(r'\[initial\].*?(?=\[time\])', re.S), "@[[initial]]\n", "'initial' wants a table, found a list"),
    ("layers", 'velocity = [', '@velocty = [', "unknown key 'velocty' in [initial]; did you mean 'velocity'?"),
    ("layers", 'velocity = ["0.5 m/s", "-0.1 m/s"]\n', "", "no key 'velocity' in [initial]"),
    ("layers", '["0.5 m/s", "-0.1 m/s"]', '@"0.5 m/s"', "'velocity' wants its components along x and y like [\"5 m/s\", \"0 m/s\"]"),
    ("layers", '["0.5 m/s", "-0.1 m/s"]', '@["0.5 m/s"]', "'velocity' wants"),
    ("layers", '["0.5 m/s", "-0.1 m/s"]', '@["0.5 m/s", "0 m/s", "0 m/s"]', "'velocity' wants"),
    ("layers", '"-0.1 m/s"', '@5', "'velocity' wants"),
    # [method]
    ("layers", re.compile(r'\[method\].*?(?=\[nonlocal)', re.S), "@[[method]]\n", "'method' wants a table, found a list"),
    ("layers", 'update_order = ', '@order = ', "unknown key 'order' in [method]; expected update_order"),
    ("layers", '"USL"', '@"MSL"', "'update_order' wants MUSL, USL or USF, found \"MSL\"; did you mean 'MUSL'?"),
    ("layers", '"GIMP"', '@"cubic"', "'shape_functions' wants GIMP or linear, found \"cubic\""),
    ("layers", '"B-bar"', '@"F-bar"', "'anti_locking' wants none or B-bar, found \"F-bar\"; did you mean 'B-bar'?"),
    ("layers", '"GIMP"', '@"linear"', "'shape_functions' \"linear\" leaves nodes at the rim next to no mass, and with update_order = \"USL\" no step"),
    ("layers", 'update_order = "USL"\nshape_functions = "GIMP"\nanti_locking = "B-bar"',
     'update_order = "USF"\nshape_functions = "GIMP"\nanti_locking = @"B-bar"', "'anti_locking' \"B-bar\" averages over cells at the end of a step"),
    ("layers", '"single"', '@"half"', "'precision' wants double or single, found \"half\""),
    ("layers", '"single"', '@32', "'precision' wants"),
    ("layers", '"0.1 1/s"', '@"-0.1 1/s"', "'damping_rate' wants at least 0 s-1"),
    ("layers", '"0.1 1/s"', '@0.1', "'damping_rate' wants a text with its unit"),
    # [nonlocal_softening]
    ("layers", re.compile(r'\[nonlocal_softening\].*?(?=\[field)', re.S), "@[[nonlocal_softening]]\n", "'nonlocal_softening' wants a table, found a list"),
    ("layers", 'length = "1.5 m"', '@lenght = "1.5 m"', "unknown key 'lenght' in [nonlocal_softening]; did you mean 'length'?"),
    ("layers", 'length = "1.5 m"\n', "", "no key 'length' in [nonlocal_softening]"),
    ("layers", '"1.5 m"', '@"0 m"', "'length' wants above 0 m"),
    ("layers", "factor = 1.5", "factor = @0.5", "'factor' wants a number at least 1 and at most 10, found 0.5"),
    ("layers", "factor = 1.5", "factor = @11", "'factor' wants a number at least 1 and at most 10, found 11"),
    ("layers", "factor = 1.5", 'factor = @"2"', "'factor' wants a number without unit"),
    # [time]
    ("cut", re.compile(r'\[time\].*', re.S), "@[[time]]\n", "'time' wants a table, found a list; write [time]"),
    ("cut", 'end = "5 s"', 'end = "5 s"\n@begin = "0 s"', "unknown key 'begin' in [time]; expected end, step, step_fraction or rest"),
    ("cut", 'end = "5 s"\n', "", "no key 'end' in [time]"),
    ("cut", '"5 s"', '@"0 s"', "'end' wants above 0 s"),
    ("cut", '"1 ms"', '@"-1 ms"', "'step' wants above 0 s"),
    ("cut", 'step = "1 ms"', 'step = "1 ms"\nstep_fraction = @0.5', "'step_fraction' cannot stand beside 'step'; give either"),
    ("layers", "step_fraction = 0.4", "step_fraction = @0", "'step_fraction' wants a number above 0 and at most 1, found 0"),
    ("layers", "step_fraction = 0.4", "step_fraction = @1.1", "'step_fraction' wants a number above 0 and at most 1, found 1.1"),
    ("layers", "step_fraction = 0.4", 'step_fraction = @"half"', "'step_fraction' wants a number without unit"),
    ("layers", re.compile(r'\[time.rest\].*?(?=\[)', re.S), "rest = @true\n", "'rest' wants a table, found true; write [time.rest]"),
    ("layers", 'hold = "3 s"', '@hld = "3 s"', "unknown key 'hld' in [time.rest]; did you mean 'hold'?"),
    ("layers", "energy_fraction = 0.02", "energy_fraction = @0", "'energy_fraction' wants a number above 0 and below 1, found 0"),
    ("layers", "energy_fraction = 0.02", "energy_fraction = @1", "'energy_fraction' wants a number above 0 and below 1, found 1"),
    ("layers", "energy_fraction = 0.02", 'energy_fraction = @"2 %"', "'energy_fraction' wants a number without unit, found \"2 %\""),
    ("layers", "strain_fraction = 0.003", "strain_fraction = @0", "'strain_fraction' wants a number above 0 and below 1, found 0"),
    ("layers", "strain_fraction = 0.003", "strain_fraction = @1", "'strain_fraction' wants a number above 0 and below 1, found 1"),
    ("layers", "strain_fraction = 0.003", 'strain_fraction = @"1 %"', "'strain_fraction' wants a number without unit, found \"1 %\""),
    ("layers", '"3 s"', '@"0 s"', "'hold' wants above 0 s"),
    # [field]
    ("layers", re.compile(r'\[field.cohesion\].*?(?=\[output\])', re.S), "@[[field]]\n", "'field' wants a table, found a list"),
    ("layers", re.compile(r'\[field.cohesion\].*?(?=\[output\])', re.S), "@[field]\n", "a table of random fields wants at least one of cohesion"),
    ("layers", "[field.cohesion]", "[field.@cohesio]", "unknown key 'cohesio' in [field]; did you mean 'cohesion'?"),
    ("layers", re.compile(r'\[field.cohesion\].*?(?=\[output\])', re.S), "[field]\ncohesion = @1\n", "'cohesion' wants a table, found 1"),
    ("layers", "cov = 0.25", "cov = 0.25\n@sd = 5", "unknown key 'sd' in [field.cohesion]"),
    ("layers", 'mean = "20 kPa"\n', "", "no key 'mean' in [field.cohesion]"),
    ("layers", 'mean = "20 kPa"', 'mean = @"0 kPa"', "'mean' wants above 0 Pa"),
    ("layers", "cov = 0.25\n", "", "no key 'cov' in [field.cohesion]"),
    ("layers", "cov = 0.25\n", "cov = @0\n", "'cov' wants a number above 0 and at most 10, found 0"),
    ("layers", "cov = 0.25\n", "cov = @25\n", "'cov' wants a number above 0 and at most 10, found 25"),
    ("layers", "cov = 0.25\n", 'cov = @"25 %"\n', "'cov' wants a number without unit, found \"25 %\""),
    ("layers", '"lognormal"', '@"log-normal"', "'marginal' wants lognormal, normal, truncated normal, beta"),
    ("bedded", 'low = "5 kPa"\n', "", "no key 'low' in [field.cohesion]"),
    ("bedded", 'high = "50 kPa"\n', "", "no key 'high' in [field.cohesion]"),
    ("bedded", 'low = "5 kPa"', 'low = @"-5 kPa"', "'low' wants at least 0 Pa"),
    ("bedded", 'high = "50 kPa"', 'high = @"0 kPa"', "'high' wants above 0 Pa"),
    ("layers", "cov = 0.25\n", 'cov = 0.25\nlow = @"5 kPa"\n', "'low' has a meaning only with marginal = \"truncated normal\""),
    ("layers", "cov = 0.25\n", 'cov = 0.25\nhigh = @"50 kPa"\n', "'high' has a meaning only with marginal = \"truncated normal\""),
    ("layers", "cov = 0.25\n", 'cov = 0.25\ndata = @["1 kPa", "2 kPa"]\n', "'data' has a meaning only with marginal = \"empirical\""),
    ("measured", re.compile('data = .*\n'), "", "no key 'data' in [field.cohesion]"),
    ("measured", re.compile('data = .*\n'), 'data = @["20 kPa"]\n', "'data' wants a list of at least 2 like [\"20 kPa\", ...], found 1"),
    ("measured", re.compile('data = .*\n'), 'data = @"20 kPa"\n', "'data' wants a list of at least 2 like [\"20 kPa\", ...], found \"20 kPa\""),
    ("measured", '"14 kPa"', '@"0 kPa"', "'data' wants above 0 Pa"),
    ("measured", '"14 kPa"', "@14", "'data' wants a text with its unit, found 14"),
    ("measured", 'marginal = "empirical"', 'marginal = "empirical"\nmean = @"20 kPa"', "'mean' has no meaning with marginal = \"empirical\""),
    ("measured", 'marginal = "empirical"', 'marginal = "empirical"\ncov = @0.3', "'cov' has no meaning with marginal = \"empirical\""),
    ("measured", 'marginal = "empirical"', 'marginal = "empirical"\nmean_gradient = @"1 kPa/m"', "'mean_gradient' has no meaning with marginal = \"empirical\""),
    ("varied", '"1 kPa/m"', "@1", "'mean_gradient' wants a text with its unit, found 1; write e.g. \"2 kPa/m\""),
    ("varied", '"constant sd"', '@"constant"', "'spread' wants constant cov or constant sd, found \"constant\""),
    ("layers", "cov = 0.25\n", 'cov = 0.25\nspread = @"constant sd"\n', "'spread' has a meaning only with a 'mean_gradient'"),
    ("varied", "[field.youngs_modulus]", '@[field.density]\nmean = "2 t/m^3"\ncov = 0.1\nhorizontal_scale = "1 m"\nvertical_scale = "1 m"\ncell = "1 m"\n\n[field.youngs_modulus]',
     "a field of density cannot stand beside one of unit weight; give either"),
    ("varied", "[soil.field.unit_weight]", "[soil.field.@unit_wieght]", "unknown key 'unit_wieght' in [soil.field]; did you mean 'unit_weight'?"),
    ("varied", re.compile(r'\[field.cross_correlation\].*?(?=\[field)', re.S), "@[[field.cross_correlation]]\n", "'cross_correlation' wants a table, found a list"),
    ("varied", '"physical"\n', '"physical"\n@of = 1\n', "unknown key 'of' in [soil.field.cross_correlation]; expected parameters, matrix or correlation_of"),
    ("varied", 'parameters = ["cohesion", "residual_cohesion"]\n', "", "no key 'parameters' in [soil.field.cross_correlation]"),
    ("varied", '["cohesion", "residual_cohesion"]', '@["cohesion"]', "'parameters' wants a list of at least 2 texts, found 1"),
    ("varied", '["cohesion", "residual_cohesion"]', '@"cohesion"', "'parameters' wants a list of at least 2 texts, found \"cohesion\""),
    ("varied", '["cohesion", "residual_cohesion"]', '["cohesion", @5]', "'parameters' wants a text in quotes, found 5"),
    ("varied", 'matrix = [[1, 0.6], [0.6, 1]]\n', "", "no key 'matrix' in [soil.field.cross_correlation]"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "@0.6", "'matrix' wants a matrix of at least 2 rows like [[1, 0.5], [0.5, 1]], found 0.6"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "@[[1, 0.6]]", "'matrix' wants a matrix of at least 2 rows"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, 0.6], @0.6]", "'matrix' wants rows of 2 numbers, found 0.6"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, 0.6], @[1]]", "'matrix' wants rows of 2 numbers, found 1"),
    ("varied", "[[1, 0.6], [0.6, 1]]", '[[1, @"0.6"], [0.6, 1]]', "'matrix' wants a number without unit, found \"0.6\""),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, @1.6], [1.6, 1]]", "'matrix' wants a number at least -1 and at most 1, found 1.6"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, @-1.6], [-1.6, 1]]", "'matrix' wants a number at least -1 and at most 1, found -1.6"),
    ("varied", '"physical"\n', '@"values"\n', "'correlation_of' wants Gaussian or physical, found \"values\""),
    ("measured", '"linear"', '@"cubic"', "'interpolation' wants cell or linear, found \"cubic\""),
    ("measured", '"borings.tsv"', '@""', "'measurements' wants the name of a file"),
    ("measured", '"borings.tsv"', "@5", "'measurements' wants a text in quotes, found 5"),
    ("measured", '"physical"', '@"real"', "'correlation_of' wants Gaussian or physical, found \"real\""),
    ("layers", '"single exponential"', '@"gaussian"', "'autocorrelation' wants single exponential, squared exponential, second-order Markov"),
    ("bedded", 'smoothness = 2.5\n', "", "no key 'smoothness' in [field.cohesion]"),
    ("bedded", "smoothness = 2.5", "smoothness = @0", "'smoothness' wants a number above 0 and at most 50, found 0"),
    ("bedded", "smoothness = 2.5", "smoothness = @51", "'smoothness' wants a number above 0 and at most 50, found 51"),
    ("bedded", "smoothness = 2.5", 'smoothness = @"1"', "'smoothness' wants a number without unit, found \"1\""),
    ("layers", '"single exponential"', '"spherical"\nsmoothness = @1', "'smoothness' has a meaning only with autocorrelation = \"Matern\""),
    ("bedded", '"elliptical"', '@"round"', "'lag' wants separable or elliptical, found \"round\""),
    ("bedded", re.compile('"Matern"\nsmoothness = 2.5\n(.*)"elliptical"', re.S), r'"binary noise"\n\1@"elliptical"', "'lag' wants separable with autocorrelation"),
    ("bedded", '"10 deg"', "@10", "'bedding_angle' wants a text with its unit, found 10"),
    ("bedded", "nugget = 0.1", "nugget = @-0.1", "'nugget' wants a number at least 0 and below 1, found -0.1"),
    ("bedded", "nugget = 0.1", "nugget = @1", "'nugget' wants a number at least 0 and below 1, found 1"),
    ("bedded", "nugget = 0.1", "nugget = @true", "'nugget' wants a number without unit, found true"),
    ("layers", '"cell"', '@"mean"', "'average' wants point or cell, found \"mean\""),
    ("bedded", '"Karhunen-Loeve"', '@"KL"', "'method' wants auto, separable, circulant, Cholesky or Karhunen-Loeve"),
    ("bedded", "variance_kept = 0.9", "variance_kept = @0", "'variance_kept' wants a number above 0 and at most 1, found 0"),
    ("bedded", "variance_kept = 0.9", "variance_kept = @2", "'variance_kept' wants a number above 0 and at most 1, found 2"),
    ("bedded", "variance_kept = 0.9", 'variance_kept = @"most"', "'variance_kept' wants a number without unit"),
    ("layers", "cov = 0.25\n", "cov = 0.25\nvariance_kept = @0.9\n", "'variance_kept' has a meaning only with method = \"Karhunen-Loeve\""),
    ("layers", 'horizontal_scale = "10 m"\n', "", "no key 'horizontal_scale' in [field.cohesion]"),
    ("layers", 'horizontal_scale = "10 m"', 'horizontal_scale = @"0 m"', "'horizontal_scale' wants above 0 m"),
    ("layers", 'vertical_scale = "1 m"\n', "", "no key 'vertical_scale' in [field.cohesion]"),
    ("layers", 'vertical_scale = "1 m"', 'vertical_scale = @"-1 m"', "'vertical_scale' wants above 0 m"),
    ("layers", 'cell = ["0.5 m", "0.25 m"]\n', "", "no key 'cell' in [field.cohesion]"),
    # [output] and [study]
    ("layers", "[output]", "@[[output]]", "'output' wants a table, found a list; write [output]"),
    ("layers", "influence_drop", "@influence_drp", "unknown key 'influence_drp' in [output]; did you mean 'influence_drop'?"),
    ("layers", '"0.5 m"\nslid', '@"0 m"\nslid', "'influence_drop' wants above 0 m"),
    ("layers", 'slid_displacement = "1 m"', 'slid_displacement = @"0 m"', "'slid_displacement' wants above 0 m"),
    ("layers", "[study]", "@[[study]]", "'study' wants a table, found a list; write [study]"),
    ("layers", "seed = 7", "seed = 7\n@samples = 3", "unknown key 'samples' in [study]; expected seed, realizations, design, block_size or modes"),
    ("layers", "seed = 7", "seed = @-7", "'seed' wants a whole number from 0 to 9223372036854775807, found -7"),
    ("layers", "seed = 7", "seed = @7.5", "'seed' wants a whole number"),
    ("layers", "seed = 7", "seed = 9223372036854775808@", "Error while parsing decimal integer: '9223372036854775808' is not representable in 64 bits"),
    ("layers", "realizations = 100", "realizations = 9223372036854775808@", "Error while parsing decimal integer"),
    ("layers", "realizations = 100", "realizations = @0", "'realizations' wants a whole number from 1 to 9223372036854775807, found 0"),
    ("layers", "realizations = 100", 'realizations = @"100"', "'realizations' wants a whole number"),
    ("bedded", '"Latin hypercube"', '@"Latin square"', "'design' wants plain, antithetic or Latin hypercube, found \"Latin square\""),
    ("bedded", "block_size = 10", "block_size = @1", "'block_size' wants a whole number from 2 to 10000, found 1"),
    ("bedded", "block_size = 10", "block_size = @20000", "'block_size' wants a whole number from 2 to 10000, found 20000"),
    ("bedded", "block_size = 10", "block_size = @1.5", "'block_size' wants a whole number from 2 to 10000, found 1.5"),
    ("bedded", "modes = 5", "modes = @0", "'modes' wants a whole number from 1 to 1000, found 0"),
    ("bedded", "modes = 5", "modes = @2000", "'modes' wants a whole number from 1 to 1000, found 2000"),
    ("bedded", "modes = 5", 'modes = @"all"', "'modes' wants a whole number from 1 to 1000, found \"all\""),
    ("bedded", 'design = "Latin hypercube"\nblock_size = 10\nmodes = 5', "block_size = @10", "'block_size' has a meaning only with design = \"Latin hypercube\""),
    ("bedded", 'design = "Latin hypercube"\nblock_size = 10\nmodes = 5', 'design = "antithetic"\nmodes = @5', "'modes' has a meaning only with design = \"Latin hypercube\""),
    # [site]
    ("layers", "[site]", "@[[site]]", "'site' wants a table, found a list; write [site]"),
    ("layers", "bearing =", "@baering =", "unknown key 'baering' in [site]; did you mean 'bearing'?"),
    ("layers", "epsg = 25832\n", "", "no key 'epsg' in [site]"),
    ("layers", "epsg = 25832", "epsg = @1023", "'epsg' wants a whole number from 1024 to 32767, found 1023"),
    ("layers", "epsg = 25832", "epsg = @32768", "'epsg' wants a whole number from 1024 to 32767, found 32768"),
    ("layers", "epsg = 25832", 'epsg = @"25832"', "'epsg' wants a whole number"),
    ("layers", re.compile(r'crest = .*\n'), "", "no key 'crest' in [site]"),
    ("layers", re.compile(r'toe = .*\n'), "", "no key 'toe' in [site]"),
    ("layers", '["565000 m", "5933000 m"]', '@"565000 m"', "'crest' wants easting and northing like"),
    ("layers", '["565000 m", "5933000 m"]', '@["565000 m"]', "'crest' wants"),
    ("layers", '["565000 m", "5933000 m"]', '@["565000 m", "5933000 m", "0 m"]', "'crest' wants"),
    ("layers", '"5933000 m"', '@5933000', "'crest' wants"),
    ("layers", '"143 deg"', '@"-37 deg"', "'bearing' wants"),
    ("layers", '"30 m"', '@"0 m"', "'width' wants above 0 m"),
]

# What the schema cannot tell: other ways to write TOML wrong, units, numbers that are not finite, what joins several keys.
READER_ALONE = [
    ("cut", '"4 m"', '@"4 kPa"', "'height' wants a length, found \"4 kPa\"; write e.g. \"5 m\""),
    ("cut", '"4 m"', '@"4 metros"', "'height' wants a length, found \"4 metros\""),
    ("cut", '"4 m"', '@"4 1/m"', "'height' wants a length, found \"4 1/m\""),
    ("cut", '"10 kPa"', '@"1 000 Pa"', "'cohesion' wants a stress, found \"1 000 Pa\"; write e.g. \"20 kPa\""),
    ("cut", '"90 deg"', '@"45 %"', "'angle' wants an angle, found \"45 %\"; write e.g. \"30 deg\""),
    ("cut", '"4 m"', '@"1e999 m"', "'height' wants a length, found \"1e999 m\""),
    ("cut", "k0 = 0.5", "k0 = @nan", "'k0' wants a finite number, found nan"),
    ("cut", "k0 = 0.5", "k0 = @inf", "'k0' wants a finite number, found inf"),
    ("cut", "poisson_ratio = 0.3\n", "poisson_ratio = @nan\n", "'poisson_ratio' wants a finite number, found nan"),
    ("cut", "points_per_cell = 2", "points_per_cell = @2.0", "'points_per_cell' wants a whole number from 1 to 8, found 2"),
    ("layers", re.compile(r"toe = .*\nbearing = .*\n"), 'toe = @["565000 m", "5933000 m"]\n', "'toe' is where the crest is: say with 'bearing'"),
    # tables that this reader needs
    ("cut", re.compile(r"\[grid\].*?(?=\[\[)", re.S), "", "no table [grid] in the scene"),
    ("cut", TWO_SOILS, r"\1\2", "no table [soil] in the scene"),
    ("cut", re.compile(r'\[base\].*?(?=\[)', re.S), "", "no table [base] in the scene"),
    ("cut", re.compile(r'\[time\].*', re.S), "", "no table [time] in the scene"),
    # the shape of the ground
    ("cut", '"90 deg"', '@"91 deg"', "'angle' wants above 0 and at most 90 deg, found \"91 deg\""),
    ("cut", 'length = "8 m"\nangle = "90 deg"', 'length = @"4 m"\nangle = "45 deg"', "'length' wants more than the 4 m that the face takes, found 4 m"),
    ("layers", '["0 m", "5 m"]', '@["1 m", "5 m"]', "'surface' wants its first point at the left wall, x = 0 m, found (1 m, 5 m)"),
    ("layers", '["12 m", "3 m"]', '@["9 m", "3 m"]', "'surface' wants points from left to right, found (9 m, 3 m) after (10 m, 5 m); an overhang"),
    ("layers", '["12 m", "3 m"]', '["12 m", "3 m"], @["12 m", "3 m"]', "'surface' has the point (12 m, 3 m) twice"),
    ("layers", '["14 m", "2 m"]', '@["14 m", "1 m"], ["14 m", "2 m"]', "'surface' folds back on itself at (14 m, 1 m)"),
    ("layers", '["12 m", "3 m"]', '@["12 m", "0 m"]', "'surface' touches the base at (12 m, 0 m); only its last point may"),
    ("layers", '["20 m", "2 m"]', '@["20 m", "6 m"]', "'surface' never falls right of its highest point (20 m, 6 m)"),
    ("layers", '["0 m", "5 m"], ["10 m", "5 m"]', '@["0 m", "5 m"]', "'surface' has its crest at the left wall"),
    # how it fits into the grid
    ("cut", '"16 m"', '@"16.1 m"', "'width' wants a whole number of cells of 0.5 m, found 16.1 m; the nearest is 16 m"),
    ("cut", '"16 m"', '@"0.1 m"', "'width' wants a whole number of cells of 0.5 m, found 0.1 m; the nearest is 0.5 m"),
    ("cut", '"16 m"', '@"1e300 m"', "'width' holds more than 1e+08 cells of 0.5 m"),
    ("cut", 'cell = "0.5 m"', 'cell = @"0.1 mm"', "'cell' divides the grid into more than 1e+08 cells"),
    ("cut", '"16 m"', '@"7.5 m"', "'width' wants at least the slope's 8 m, found 7.5 m"),
    ("cut", '"5 m"', '@"4 m"', "'height' wants at least 4.5 m, a cell above the slope, found 4 m"),
    ("layers", '["20 m", "2 m"]', '@["19 m", "2 m"]', "'surface' ends in the air at x = 19 m; wants its last point on the base, y = 0 m, or at the right wall, x = 20 m"),
    ("layers", '["0.5 m", "25 cm"]', '@["0.5 m", "40 cm"]', "'cell' wants level ground at a whole number of point spacings, found it at 5 m with points every 0.4 m"),
    ("layers", re.compile(r'(\["20 m", "2 m"\].*)right = "roller"', re.S), r"@\1", "'surface' goes on to the right wall, which is open"),
    # soils
    ("cut", '"sand"', '@"silt"', "'name' wants a name of its own, found \"silt\" twice"),
    ("layers", '"4 kPa"', '@"21 kPa"', "'residual_cohesion' wants at most 'cohesion', found \"21 kPa\""),
    ("layers", '"25 deg"', '@"31 deg"', "'residual_friction_angle' wants at most 'friction_angle', found \"31 deg\""),
    ("layers", 'dilation_angle = "5 deg"', 'dilation_angle = @"31 deg"', "'dilation_angle' wants at most 'friction_angle', found \"31 deg\""),
    ("cut", '"35 deg"', '@"90 deg"', "'friction_angle' wants at least 0 and below 90 deg, found \"90 deg\""),
    ("cut", '"10 kPa"', '@"0 kPa"', "'cohesion' wants more than 0 Pa in a soil without friction"),
    ("layers", 'residual_cohesion = "4 kPa"\nsoftening_shape = 8\n', 'residual_cohesion = @"4 kPa"\n', "'residual_cohesion' below the peak wants 'softening_shape' beside it"),
    ("layers", "softening_shape = 8\n", "softening_shape = @0\n", "'softening_shape' wants a number above 0, found 0"),
    ("layers", re.compile(r'= "25 deg"(.*?)softening_shape = 5\n', re.S), r'= @"25 deg"\1', "'residual_friction_angle' below the peak wants 'softening_shape' beside it"),
    ("layers", '["14 m", "1 m"]', '@["-14 m", "1 m"]', "'top' wants points from left to right"),
    # time and fields
    ("layers", '"1 min"', '@"1 s"', "'end' wants at least the 2 s over which gravity grows, found 1 s"),
    ("cut", '"1 ms"', '@"6 s"', "'step' wants at most the end, 5 s, found 6 s"),
    ("layers", '"3 s"', '@"60 s"', "'hold' wants less than the whole run of 60 s, found 60 s"),
    ("layers", 'mean = "20 kPa"', 'mean = @"4 kPa"', "'mean' wants more than the residual cohesion of soil \"clay\", 4 kPa, the floor of the field, found 4 kPa"),
    ("varied", 'mean = "3 kPa"', 'mean = @"3 m"', "'mean' wants a stress, found \"3 m\""),
    ("varied", '"1 kPa/m"', '@"1 kPa"', "'mean_gradient' wants a stress over a length, found \"1 kPa\"; write e.g. \"2 kPa/m\""),
    ("varied", '"0.5 MPa/m"', '@"-0.6 MPa/m"', "'mean_gradient' wants a mean above 0 at every depth, found -"),
    ("layers", 'mean = "20 kPa"', 'mean = @"20 kPa"\nmean_gradient = "-4 kPa/m"',
     "'mean' wants more than the residual cohesion of soil \"clay\", 4 kPa, the floor of the field, found 0.5 kPa at some depth"),
    ("varied", 'mean = "30 deg"', 'mean = @"89.5 deg"', "'mean' wants below 89 deg, found 89.5 deg"),
    ("varied", 'mean = "30 deg"', 'mean = @"20 deg"', "'mean' wants more than the residual friction angle of soil \"fill\", 20 deg, the floor of the field, found 20 deg"),
    ("varied", re.compile(r'residual_cohesion = "2 kPa"\nsoftening_shape = 8(.*?)\[soil.field.residual_cohesion\]', re.S), r"\1@[soil.field.residual_cohesion]",
     "a field of residual cohesion has no effect in soil \"clay\", which does not soften: give the soil a softening_shape"),
    ("varied", '["cohesion", "residual_cohesion"]', '["cohesion", @"cohesoin"]', "'parameters' wants parameters of fields beside it, found \"cohesoin\"; did you mean 'cohesion'?"),
    ("varied", '["cohesion", "residual_cohesion"]', '["cohesion", @"cohesion"]', "'parameters' has \"cohesion\" twice"),
    ("varied", '["cohesion", "residual_cohesion"]', '["cohesion", @"unit_weight"]', "'parameters' wants fields that share mesh, autocorrelation, average and method, but those of \"cohesion\" and \"unit_weight\" differ in their mesh"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "@[[1, 0.6, 0], [0.6, 1, 0], [0, 0, 1]]", "'matrix' wants a row for each of the 2 parameters, found 3"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, 0.6], @[0.6, 0.9]]", "'matrix' wants ones on its diagonal, found 0.9"),
    ("varied", "[[1, 0.6], [0.6, 1]]", "[[1, 0.6], @[0.5, 1]]", "'matrix' wants to be symmetric, found 0.5 and 0.6"),
    ("varied", "[[1, -0.5, 0.2], [-0.5, 1, 0.3], [0.2, 0.3, 1]]", "@[[1, -0.9, 0.9], [-0.9, 1, 0.9], [0.9, 0.9, 1]]",
     "'matrix' is not positive definite: its least eigenvalue is -0.8, so these correlations contradict each other; all of them times 0.55 would do"),
    ("varied", "[soil.field.unit_weight]\nmean = \"17 kN/m^3\"", "@[soil.field.density]\nmean = \"1.7 t/m^3\"", "a field of density cannot stand beside one of unit weight"),
    ("varied", '"clay"', '@"clay/silt"', "'name' wants no '/' in a soil with a field of its own, found \"clay/silt\": it names datasets"),
    ("bedded", '"10 deg"', '@"100 deg"', "'bedding_angle' wants"),
    ("bedded", 'low = "5 kPa"', 'low = @"20 kPa"', "'low' wants less than the mean"),
    ("bedded", 'high = "50 kPa"', 'high = @"20 kPa"', "'high' wants more than the mean"),
    ("measured", re.compile('data = .*\n'), 'data = @["3 kPa", "5 kPa"]\n', "'data' wants more than the residual cohesion of soil"),
    ("layers", 'cell = ["0.5 m", "0.25 m"]', 'cell = @"1 um"', "'cell' divides the slope into more than 1e+08 cells"),
]


def changed(bad):
    """The text of a bad scene and the place, (line, column), that its message names."""
    name, old, new, _ = bad
    good = SCENES[name]
    pattern = old if isinstance(old, re.Pattern) else re.compile(re.escape(old))
    matches = list(pattern.finditer(good))
    if len(matches) != 1:
        sys.exit(f"{name}: {old!r} stands {len(matches)} times, expected once")
    match = matches[0]
    replacement = match.expand(new) if isinstance(old, re.Pattern) else new
    text = good[: match.start()] + replacement + good[match.end() :]
    mark = text.find("@")
    if mark < 0 and match.group().startswith("["):
        mark = 0
    if mark < 0:
        mark = text.rindex("\n[", 0, match.start() + 1) + 1
    before = text[:mark].split("\n")
    return text.replace("@", ""), (len(before), len(before[-1]) + 1)


def answers(texts):
    """What the reader says of each text: its lines "0" or "65 <path>:<line>:<column>: <message>", the path cut off."""
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, f"{number}.toml") for number in range(len(texts))]
        for path, text in zip(paths, texts):
            path.write_text(text)
        output = subprocess.run([READ_SCENE, *paths], capture_output=True, text=True, check=True).stdout.splitlines()
        if len(output) != len(texts):
            sys.exit(f"{READ_SCENE} gave {len(output)} lines for {len(texts)} scenes")
        return [line.replace(f"{path}:", "") for path, line in zip(paths, output)]


def schema_errors(text):
    return list(VALIDATOR.iter_errors(tomllib.loads(text)))


def check_good():
    shipped = sorted([*TOP.glob("pipelines/**/*.toml"), *TOP.glob("tests/scenes/*.toml")])
    texts = [path.read_text() for path in shipped]
    for path, text, answer in zip(shipped, texts, answers(texts)):
        for error in schema_errors(text):
            fault(f"{path}: {error.json_path}: {error.message}")
        if answer != "0":
            fault(f"{path}: {answer}")
    used = {shared(key) for text in SCENES.values() for key in keys_of(tomllib.loads(text))}
    for key in sorted({shared(key) for key in schema_keys()} - used):
        fault(f"no scene in tests/scenes/ has the key {key}")


def shared(key):
    """Fields of all parameters, and those of one soil, have the same keys: they are counted as of one field of all soils."""
    return re.sub(r"^(\.soil)?\.field\.(?!cross_correlation)\w+\.", ".field.<parameter>.", re.sub(r"^\.soil(?=\.field)", "", key))


def keys_of(value, path=""):
    """Dotted paths of all keys below a value of TOML; items of a list share the list's path."""
    if isinstance(value, list):
        for item in value:
            yield from keys_of(item, path)
    if isinstance(value, dict):
        for key, item in value.items():
            yield f"{path}.{key}"
            yield from keys_of(item, f"{path}.{key}")


def schema_keys(schema=SCHEMA, path=""):
    """The same of what the schema allows."""
    schema = resolved(schema)
    for key, item in schema.get("properties", {}).items():
        yield f"{path}.{key}"
        yield from schema_keys(item, f"{path}.{key}")
    if isinstance(schema.get("items"), dict):
        yield from schema_keys(schema["items"], path)


def resolved(schema):
    return SCHEMA["$defs"][schema["$ref"].rpartition("/")[2]] if "$ref" in schema else schema


def check_bad():
    cases = [(bad, True) for bad in BAD] + [(bad, False) for bad in READER_ALONE]
    changes = [changed(bad) for bad, _ in cases]
    for (bad, is_for_schema), (text, place), answer in zip(cases, changes, answers([text for text, _ in changes])):
        expected = f"65 {place[0]}:{place[1]}: {bad[3]}"
        if not answer.startswith(expected):
            fault(f"{bad[:3]}:\n  expected {expected}\n  found    {answer}")
        if bool(schema_errors(text)) != is_for_schema:
            fault(f"{bad[:3]}: the schema {'accepts' if is_for_schema else 'refuses'} it")


ASSERTIONS = {"type", "enum", "pattern", "minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum", "minLength", "minItems", "maxItems", "minProperties", "not",
              "additionalProperties"}


def rules(schema=SCHEMA, path="#"):
    """Every rule: where it stands and an identity that errors of the validator share. Each required key is a rule of its own."""
    for keyword, value in schema.items():
        if keyword in ASSERTIONS:
            yield f"{path}/{keyword}", (id(schema), keyword)
        elif keyword == "required":
            yield from ((f"{path}/required/{key}", (id(schema), keyword, key)) for key in value)
        elif keyword in ("properties", "$defs", "dependentSchemas"):
            for key, item in value.items():
                yield from rules(item, f"{path}/{keyword}/{key}")
        elif keyword in ("prefixItems", "allOf"):
            for index, item in enumerate(value):
                yield from rules(item, f"{path}/{keyword}/{index}")
        elif keyword in ("then", "else", "items"):
            yield from rules(value, f"{path}/{keyword}")
        elif keyword not in ("if", "$schema", "title", "description", "default", "examples", "$ref"):
            sys.exit(f"{path}: this test does not know the keyword '{keyword}'")


def broken_rules(error):
    identity = (id(error.schema), error.validator)
    if error.validator != "required":
        return {identity}
    return {(*identity, key) for key in error.validator_value if key not in error.instance}


def check_rules():
    broken = {rule for bad in BAD for error in schema_errors(changed(bad)[0]) for rule in broken_rules(error)}
    listed = {identity: path for path, identity in rules()}
    if not broken <= listed.keys():
        sys.exit("the validator names rules that this test did not list")
    for identity in listed.keys() - broken - {(id(SCHEMA), "type")}:  # no file of TOML is anything but a table
        fault(f"no bad scene for the rule {listed[identity]}")


VALUES = ["true", "0", "1", "-1", "nan", "inf", '""', '"x"', '"0 m"', '"-1 m"', '".5 kPa"', '"1e1 deg"', '"1 e"', '"+-1 m"', '"+2. m"',
          '"stick"', "[]", "{}", '["1 m", "1 m"]', '[["0 m", "1 m"], ["1 m", "0 m"]]', "1979-05-27"]


def variants(text, known_lines):
    """A good scene with one line removed or one value replaced; lines that another scene has too are passed over."""
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if line in known_lines:
            continue
        match = re.match(r"(\w+ = )", line)
        replacements = [match.group(1) + value for value in VALUES] if match else []
        if match or line.startswith("["):
            for replacement in ["", *replacements]:
                yield "\n".join([*lines[:number], replacement, *lines[number + 1 :]])


def parsed(text):
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError:
        return None


def check_agree():
    layers = SCENES["layers"]
    cut = SCENES["cut"]
    texts = [*variants(layers, []), *variants(cut, layers.split("\n")), *variants(SCENES["varied"], [*layers.split("\n"), *cut.split("\n")])]
    scenes = [(text, scene) for text in texts if (scene := parsed(text)) is not None]
    refused = 0
    for (text, scene), answer in zip(scenes, answers([text for text, _ in scenes])):
        error = next(VALIDATOR.iter_errors(scene), None)
        refused += error is not None
        if error and not answer.startswith("65 "):
            fault(f"the schema refuses what the reader accepts: {error.json_path}: {error.message}")
    if refused < 1000:
        sys.exit(f"only {refused} of {len(scenes)} scenes were refused; the variants are not what they should be")


def fault(message):
    global faults
    faults += 1
    print(message)


faults = 0
if len(sys.argv) != 3:
    sys.exit(__doc__)
READ_SCENE = sys.argv[2]
{"good": check_good, "bad": check_bad, "rules": check_rules, "agree": check_agree}[sys.argv[1]]()
sys.exit(faults > 0)
