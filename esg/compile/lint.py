"""What Unreal's header tool and build would reject but a C++ compiler accepts.

`lint` returns every complaint; `generated_header` writes the stand-in for the header tool's output.
"""

from __future__ import annotations

import re

UNITS = frozenset({"cm", "kg", "s", "deg", "cm/s"})
"""Names of units that Unreal's property editor knows and emitted classes use."""

HEADER_OF = {
    "UStaticMeshComponent": "Components/StaticMeshComponent.h",
    "USceneComponent": "Components/SceneComponent.h",
    "UPrimitiveComponent": "Components/PrimitiveComponent.h",
    "UStaticMesh": "Engine/StaticMesh.h",
    "FCollisionShape": "CollisionShape.h",
    "FHitResult": "Engine/EngineTypes.h",
    "ECC_Vehicle": "Engine/EngineTypes.h",
    "GetWorld": "Engine/World.h",
    "AWorldSettings": "GameFramework/WorldSettings.h",
    "FApp": "Misc/App.h",
    "FPhysicsCommand": "Physics/PhysicsInterfaceCore.h",
    "EConstraintFrame": "PhysicsEngine/ConstraintInstance.h",
    "UPhysicsConstraintComponent": "PhysicsEngine/PhysicsConstraintComponent.h",
    "UPhysicalMaterial": "PhysicalMaterials/PhysicalMaterial.h",
    "FBodyInstance": "PhysicsEngine/BodyInstance.h",
    "ConstructorHelpers": "UObject/ConstructorHelpers.h",
}
"""Unreal header that declares each name an emitted source uses."""

ENGINE_HEADERS = frozenset({*HEADER_OF.values(), "CoreMinimal.h", "GameFramework/Actor.h"})

PLAYER = "EsgScene"
"""File of the class that plays all scenes, and its name without Unreal's A."""

_CLASS = re.compile(
    r"UCLASS\([^)]*\)\s*class\s+(?:\w+_API\s+)?([AU]\w+)\s*:\s*public\s+(\w+)\s*\{\s*"
    r"GENERATED_BODY\(\)"
)
_STRUCT = re.compile(r"USTRUCT\([^)]*\)\s*struct\s+(\w+)\s*\{\s*(GENERATED_BODY\(\))?")
_MEMBER = re.compile(
    r"^[ \t]*((?:const )?[\w:<>]+[\w:<>, *&]*?)[ \t]+(\w+)(?:[ \t]*=[^;]*)?;", re.M
)
_STRING = re.compile(r'"(?:[^"\\\n]|\\.)*"')


def lint(header: str, source: str, stem: str) -> list[str]:
    """Complaints about a class, empty if there are none.

    Args:
        header, source: Text of the two files.
        stem: Their file name without extension.
    """
    out: list[str] = []
    includes = re.findall(r'^#include\s+"([^"]+)"', header, re.M)
    if not includes or includes[-1] != f"{stem}.generated.h":
        out.append(f"{stem}.generated.h must be the header's last include")
    if "#pragma once" not in header:
        out.append("the header lacks #pragma once")
    parents = {m.group(1): m.group(2) for m in _CLASS.finditer(header)}
    if not parents:
        return [*out, "no UCLASS() with GENERATED_BODY() as first line of its body"]
    name = list(parents)[-1]
    if name[1:] != stem:
        out.append(f"class {name} does not match its file {stem}.h")
    out += [
        f"USTRUCT {m.group(1)} lacks GENERATED_BODY()"
        for m in _STRUCT.finditer(header)
        if not m.group(2)
    ]
    out += [
        f"USTRUCT {m.group(1)} must start with F"
        for m in _STRUCT.finditer(header)
        if not m.group(1).startswith("F")
    ]
    out += _lint_includes(header, source, stem)
    out += _lint_reflection(header, source)
    out += _lint_text(header, source)
    for each, parent in parents.items():
        out += _lint_constructor(source, each)
        out += _lint_lifecycle(header, source) if parent == "AActor" else []
    return out


def _code(text: str) -> str:
    """Text without comments and string contents."""
    text = _STRING.sub('""', text)
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)


def _lint_includes(header: str, source: str, stem: str) -> list[str]:
    includes = re.findall(r'^#include\s+"([^"]+)"', source, re.M)
    out: list[str] = []
    if not includes or includes[0] != f"{stem}.h":
        out.append(f"the source must include {stem}.h first")
    known = {*ENGINE_HEADERS, f"{PLAYER}.h"}
    out += [f"unknown engine header {i}" for i in includes[1:] if i not in known]
    out += [f"#include {i}" for i in re.findall(r"^#include\s+(<[^>]+>)", source, re.M)]
    includes += re.findall(r'^#include\s+"([^"]+)"', header, re.M)
    if f"{PLAYER}.h" in includes:
        includes.append("CollisionShape.h")
    code = _code(source)
    for symbol, path in HEADER_OF.items():
        if re.search(rf"\b{symbol}\b", code) and path not in includes:
            out.append(f"{symbol} needs #include {path}")
    return out


def _lint_reflection(header: str, source: str) -> list[str]:
    out: list[str] = []
    functions = re.findall(r"AddDynamic\(\s*this\s*,\s*&\w+::(\w+)\s*\)", source)
    for function in dict.fromkeys(functions):
        if not re.search(rf"UFUNCTION\([^)]*\)\s*(?:virtual\s+)?void\s+{function}\b", header):
            out.append(f"{function} is bound by AddDynamic but is no UFUNCTION()")
    for match in re.finditer(r"TObjectPtr<\w+>>?\s+(\w+)\s*;", header):
        before = header[: match.start()].rsplit(";", 1)[-1]
        if "UPROPERTY(" not in before:
            out.append(f"{match.group(1)} is no UPROPERTY and would be garbage-collected")
    for meta in re.findall(r'Units\s*=\s*"([^"]*)"', header):
        if meta not in UNITS:
            out.append(f"unit {meta!r} is unknown to Unreal")
    for low, high in re.findall(r'ClampMin\s*=\s*"([^"]+)", ClampMax\s*=\s*"([^"]+)"', header):
        if float(low) >= float(high):
            out.append(f"range {low} to {high} is empty")
    for match in re.finditer(r"UPROPERTY\((EditAnywhere[^\n]*)\)\n([^\n;]+);", header):
        if "Category" not in match.group(1):
            out.append(f"editable {match.group(2).split()[1]} has no Category")
    # Unreal lets no class declare what one that it is derived from has.
    names = [m.group(2) for m in _MEMBER.finditer(_class_bodies(header))]
    out += [
        f"member {n} is declared twice" for n in sorted({n for n in names if names.count(n) > 1})
    ]
    return out


def _class_bodies(header: str) -> str:
    found = _CLASS.search(header)
    body = _code(header[found.end() :]) if found else ""
    return re.sub(r"struct \w+\s*\{.*?\};", "", body, flags=re.S)


def _lint_text(header: str, source: str) -> list[str]:
    out: list[str] = []
    for line in source.splitlines():
        if line.lstrip().startswith(("#include", "//")):
            continue
        for match in _STRING.finditer(line):
            if not line[: match.start()].rstrip().endswith("TEXT("):
                out.append(f"string {match.group()} is not wrapped in TEXT()")
    for text in (header, source):
        if not text.isascii():
            out.append("the file holds characters outside ASCII")
        if "??/" in text or re.search(r"\\\s*$", text, re.M):
            out.append("a line is continued by a backslash or a trigraph")
    return out


def _lint_constructor(source: str, name: str) -> list[str]:
    """Calls that compile in a constructor but have no physics body yet."""
    match = re.search(rf"^{name}::{name}\(\)\s*\n\{{(.*?)^\}}", source, re.S | re.M)
    if not match:
        return [f"no constructor {name}::{name}()"]
    out: list[str] = []
    for call in ("SetPhysicsLinearVelocity", "SetPhysicsAngularVelocityInDegrees", "AddImpulse"):
        if call in _code(match.group(1)):
            out.append(f"{call} in the constructor: there is no physics body yet")
    return out


def _lint_lifecycle(header: str, source: str) -> list[str]:
    """What an actor that is played must have; a class of ours inherits it."""
    out: list[str] = []
    for function, arguments in (
        ("BeginPlay", ""),
        ("Tick", "DeltaTime"),
        ("OnConstruction", "Transform"),
    ):
        if not re.search(rf"virtual void {function}\([^)]*\) override;", header):
            out.append(f"{function} is not declared as an override")
        if f"Super::{function}({arguments});" not in source:
            out.append(f"{function} does not call Super::{function}")
    if "bCanEverTick = true" not in source:
        out.append("ticking is not enabled: the program would never run")
    return out


def generated_header(header: str, stem: str) -> str:
    """Stand-in for the header tool's output: one macro per GENERATED_BODY line.

    Args:
        header: Text of the class's header.
        stem: Its file name without extension.
    """
    classes = {
        header.count("\n", 0, m.end()) + 1: (m.group(2), m.group(1))
        for m in _CLASS.finditer(header)
    }
    lines = [
        "#pragma once",
        "#undef GENERATED_BODY",
        "#define ESG_GLUE3(A, B, C) A##B##C",
        "#define ESG_GLUE2(A, B, C) ESG_GLUE3(A, B, C)",
        f"#define GENERATED_BODY(...) ESG_GLUE2({stem}_, __LINE__, _BODY)",
    ]
    lines[2:2] = ["#undef ESG_GLUE3", "#undef ESG_GLUE2"]
    for number, line in enumerate(header.splitlines(), 1):
        if "GENERATED_BODY()" in line:
            parent, name = classes.get(number, ("", ""))
            body = f"public: typedef {parent} Super; typedef {name} ThisClass; private:"
            body = body if name else ""
            lines.append(f"#undef {stem}_{number}_BODY")
            lines.append(f"#define {stem}_{number}_BODY {body}".rstrip())
    return "\n".join(lines) + "\n"
