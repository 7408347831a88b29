# SPDX-License-Identifier: Apache-2.0
"""The models that are shipped are right by the schema that editors use, and wrong ones are not. Without
python3-jsonschema and python3-yaml it is skipped (77)."""
import json
import pathlib
import sys

try:
    import jsonschema
    import yaml
except ImportError as missing:
    print(f"skipped: {missing}")
    sys.exit(77)

WRONG = ["{roles: {r: {}}}", "{role: {}}", "{block: b, content: []}", "{block: b, type: lop, content: [{task: t, type: go}]}",
         "{block: b, exit: [{message: m}], content: [{task: t, type: go}]}",
         "{scms: {s: {constraints: [{distance-to: p, azimuth: [p, q], is: <, than: 3}]}}}",
         "{models: {m: {variants: {v: {roles: [r], coordination: {arity: {r: {at-least: 1, at-most: 2}}}}}}}}"]


def main():
    folder = pathlib.Path(sys.argv[1])
    schema = json.loads((folder / "interaction.schema.json").read_text())
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    faults, files = [], sorted(folder.rglob("*.yaml"))
    for path in files:
        faults += [f"{path}: {error.message}" for error in validator.iter_errors(yaml.safe_load(path.read_text()))]
    faults += [f"taken for right: {text}" for text in WRONG if validator.is_valid(yaml.safe_load(text))]
    print("\n".join(faults) or f"{len(files)} files are right, {len(WRONG)} wrong texts are not")
    return 1 if faults or not files else 0


if __name__ == "__main__":
    sys.exit(main())
