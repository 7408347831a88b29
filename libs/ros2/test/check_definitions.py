# SPDX-License-Identifier: Apache-2.0
"""idl/ros2.idl against the definitions of the packages that Debian has (ros-*-msgs, of ROS 1), field by field.

check_definitions.py idl/ros2.idl [FOLDER]     FOLDER: where packages lie, /usr/share

What ROS 2 has otherwise is listed below; everything else must be the same.
"""
import pathlib
import re
import sys

SKIPPED = 77
PRIMITIVES = {"float64": "double", "float32": "float", "bool": "boolean", "byte": "octet", "uint16": "unsigned short",
              "int32": "long", "uint32": "unsigned long", "string": "string", "int8": "int8", "uint8": "uint8",
              "time": "builtin_interfaces/Time"}
# ROS 2: headers are not numbered; its Time is a message of its own, with seconds that have a sign.
LEFT_OUT = {"std_msgs/Header": {"seq"}}
NEW_IN_ROS2 = {"builtin_interfaces/Time": [("long", "sec"), ("unsigned long", "nanosec")]}


def fields_of_msg(package, text):
    """[(type, name)] of a .msg."""
    fields = []
    for line in text.splitlines():
        words = line.split("#")[0].split()
        if len(words) < 2 or "=" in line.split("#")[0]:
            continue
        kind, array = re.fullmatch(r"([\w/]+)(\[\d*\])?", words[0]).groups()
        kind = PRIMITIVES.get(kind, "std_msgs/Header" if kind == "Header" else kind)
        if kind[0].isupper():
            kind = f"{package}/{kind}"
        fields.append((kind + (array or ""), words[1]))
    return fields


def fields_of_idl(text):
    """{"package/Name": [(type, name)]}"""
    found, package = {}, None
    text = re.sub(r"//[^\n]*", "", text)
    for module, struct, body in re.findall(r"module (\w+) \{ module msg|struct (\w+)_ \{(.*?)\};", text, re.S):
        if module:
            package = module
            continue
        fields = []
        for field in filter(None, (one.strip() for one in body.split(";"))):
            kind, name, size = re.fullmatch(r"(.+?)\s+(\w+)(\[\d+\])?", field).groups()
            inner = re.fullmatch(r"sequence<(.+)>", kind)
            kind = inner.group(1) if inner else kind
            message = re.fullmatch(r"(\w+)::msg::dds_::(\w+)_", kind)
            kind = "/".join(message.groups()) if message else kind
            fields.append((kind + (size or ("[]" if inner else "")), name))
        found[f"{package}/{struct}"] = fields
    return found


def main():
    ours = fields_of_idl(pathlib.Path(sys.argv[1]).read_text())
    share = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "/usr/share")
    if not (share / "sensor_msgs/msg/NavSatFix.msg").exists():
        print("SKIPPED: the packages ros-*-msgs are not installed")
        return SKIPPED
    assert len(ours) >= 16, sorted(ours)
    wrong = 0
    for name, fields in sorted(ours.items()):
        package, message = name.split("/")
        theirs = NEW_IN_ROS2.get(name)
        if theirs is None:
            theirs = fields_of_msg(package, (share / package / "msg" / (message + ".msg")).read_text())
            theirs = [one for one in theirs if one[1] not in LEFT_OUT.get(name, ())]
        if fields != theirs:
            wrong += 1
            print(f"{name}: {fields}, but defined as {theirs}")
    print(f"{len(ours)} messages compared, {wrong} otherwise")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
