# edits are quoted as they stand in the emitted files
"""Faults seeded into an emitted class: each must be caught before or while the class runs.

The class is the self-contained form of the emitted one, which holds what plays all scenes as well.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from helpers import both, first_touches, vouched, written
import numpy as np
import pytest
import scenes

from esg.compile import ClassError, ReplayError, compile_many, replay_class
from esg.compile.build import read_classes
from esg.compile.replay import ClassReplay
from esg.compile.unreal.selfcontained import self_contained
from esg.engines.scene import Rollout


@dataclass(frozen=True)
class Fault:
    """One edit of the class and what must complain.

    Args:
        file: `h` or `cpp`.
        old, new: The edit; `old` must occur.
        caught: Exception that reports it, or a check of log and rollout against the program.
        says: Part of the message.
    """

    file: str
    old: str
    new: str
    caught: type[Exception] | Callable[[ClassReplay, Rollout], bool]
    says: str = ""


def differs(replayed: ClassReplay, rollout: Rollout) -> bool:
    """The comparison with the control program's replay fails."""
    one, two = first_touches(replayed.rollout), first_touches(rollout)
    late = any(abs(one[p] - two[p]) > rollout.dt * 1.01 for p in one.keys() & two.keys())
    moved = np.abs(replayed.rollout.position - rollout.position).max() > 1e-3
    return one.keys() != two.keys() or late or bool(moved)


def overlap_logged(replayed: ClassReplay, _: Rollout) -> bool:
    return any("LAYOUT overlaps=" in x and "pass=0" in x for x in replayed.log)


def event_lost(replayed: ClassReplay, _: Rollout) -> bool:
    return not any(e["event"] == "EVENT_HIT" for e in replayed.events())


INCLUDE = '#include "PhysicalMaterials/PhysicalMaterial.h"\n'
FAULTS = {
    "callback is no UFUNCTION": Fault("h", "\tUFUNCTION()\n", "", ClassError, "no UFUNCTION"),
    "component is no UPROPERTY": Fault(
        "h",
        '\tUPROPERTY(VisibleAnywhere, Category = "ESG")\n\tTObjectPtr<UStaticMeshComponent> GroundPlane;',
        "\tTObjectPtr<UStaticMeshComponent> GroundPlane;",
        ClassError,
        "garbage-collected",
    ),
    "struct lacks GENERATED_BODY": Fault(
        "h", "struct FEsgScene_S6Body\n{\n\tGENERATED_BODY()\n", "struct FEsgScene_S6Body\n{\n",
        ClassError, "lacks GENERATED_BODY",
    ),
    "generated header is not last": Fault(
        "h", '#include "GameFramework/Actor.h"\n#include "EsgScene_S6.generated.h"',
        '#include "EsgScene_S6.generated.h"\n#include "GameFramework/Actor.h"',
        ClassError, "last include",
    ),
    "class is not called like its file": Fault(
        "h", "class ESGSCENES_API AEsgScene_S6 :", "class ESGSCENES_API AEsgScene_S5 :",
        ClassError, "does not match its file",
    ),
    "body handle taken by const reference": Fault(
        "cpp", "[&](FPhysicsActorHandle& Actor)", "[&](const FPhysicsActorHandle& Actor)",
        ClassError, "SetMassSpaceInertiaTensor_AssumesLocked",
    ),
    "unit Unreal does not know": Fault("h", 'Units = "kg"', 'Units = "stone"', ClassError, "stone"),
    "empty range": Fault(
        "h", 'ClampMin = "0", ClampMax = "1"', 'ClampMin = "1", ClampMax = "0"', ClassError, "range",
    ),
    "property declared twice": Fault(
        "h", "\tdouble MaxHitTime = 15.0;", "\tdouble MaxHitTime = 15.0;\n\n\tdouble MaxHitTime = 15.0;",
        ClassError, "twice",
    ),
    "missing include": Fault("cpp", INCLUDE, "", ClassError, "needs #include"),
    "header that Unreal does not have": Fault(
        "cpp", INCLUDE, INCLUDE + '#include "Physics/Magic.h"\n', ClassError, "unknown engine header",
    ),
    "string without TEXT": Fault(
        "cpp", 'SetCollisionProfileName(TEXT("NoCollision"))', 'SetCollisionProfileName("NoCollision")',
        ClassError, "TEXT",
    ),
    "no call of Super": Fault("cpp", "\tSuper::BeginPlay();\n", "", ClassError, "Super::BeginPlay"),
    "ticking is off": Fault(
        "cpp", "bCanEverTick = true", "bCanEverTick = false", ClassError, "ticking is not enabled",
    ),
    "velocity in the constructor": Fault(
        "cpp", "\tCar1Settings.bSimulated = true;",
        "\tCar1Mesh->SetPhysicsLinearVelocity(FVector(1.0, 0.0, 0.0));\n\tCar1Settings.bSimulated = true;",
        ClassError, "no physics body yet",
    ),
    "velocity in BeginPlay before physics": Fault(
        "cpp", "\tCheckLayout();\n}\n\nvoid AEsgScene_S6Player::Pin",
        "\tCheckLayout();\n\tBodies[0].Component->SetPhysicsLinearVelocity(FVector(1.0, 0.0, 0.0));\n}\n\n"
        "void AEsgScene_S6Player::Pin",
        ReplayError, "before there is a physics body",
    ),
    "misspelled API": Fault(
        "cpp", "->SetLinearDamping(Settings", "->SetLinearDampening(Settings", ClassError,
        "SetLinearDampening",
    ),
    "wrong order of arguments": Fault(
        "cpp", "SetMassOverrideInKg(NAME_None, Settings.Mass, true)",
        "SetMassOverrideInKg(Settings.Mass, NAME_None, true)", ClassError, "error",
    ),
    "format does not match its value": Fault(
        "cpp", "SCENE_END t=%.4f", "SCENE_END t=%d", ClassError, "format",
    ),
    "unused variable": Fault(
        "cpp", "\tRecheckEvents();\n\tDispatch", "\tint32 Left = 0;\n\tRecheckEvents();\n\tDispatch",
        ClassError, "unused",
    ),
    "integer where a component belongs": Fault(
        "cpp", "RunHoldVelocity(Car1Mesh,", "RunHoldVelocity(42,", ClassError, "invalid conversion",
    ),
    "simulation of a static component": Fault(
        "cpp", "Settings.bSimulated ? EComponentMobility::Movable : EComponentMobility::Static",
        "EComponentMobility::Static", ReplayError, "not Movable",
    ),
    "static under a movable root": Fault(
        "cpp", "\tSceneOrigin->SetMobility(EComponentMobility::Static);\n", "", ReplayError,
        "refuses the attachment",
    ),
    "two components of one name": Fault(
        "cpp", 'CreateMesh(TEXT("Table1")', 'CreateMesh(TEXT("Car1")', ReplayError, "two subobjects",
    ),
    "asset path that does not exist": Fault(
        "cpp", "SM_Table1.SM_Table1", "SM_Tabel1.SM_Tabel1", ReplayError, "no collision shapes",
    ),
    "no mass": Fault(
        "cpp", "\tBody->SetMassOverrideInKg(NAME_None, Settings.Mass, true);\n", "", ReplayError, "mass",
    ),
    "no damping": Fault(
        "cpp", "\tBody->SetAngularDamping(Settings.AngularDamping);\n", "", ReplayError, "damping",
    ),
    "no material": Fault(
        "cpp", "\tGroundPlane->SetPhysMaterialOverride(CreateMaterial(GroundFriction, GroundRestitution));\n",
        "", ReplayError, "physical material",
    ),
    "mass after the mass frame": Fault(
        "cpp", "\t\tif (Body.Settings->bReportsHits)",
        "\t\tif (Body.Settings->bSimulated)\n\t\t{\n"
        "\t\t\tBody.Component->SetMassOverrideInKg(NAME_None, Body.Settings->Mass, true);\n\t\t}\n"
        "\t\tif (Body.Settings->bReportsHits)",
        ReplayError, "centre of mass and inertia",
    ),
    "materials that multiply": Fault(
        "cpp", "FrictionCombineMode = EFrictionCombineMode::Average",
        "FrictionCombineMode = EFrictionCombineMode::Multiply", ReplayError, "average",
    ),
    "gravity left to the project": Fault(
        "cpp", "bWorldGravitySet = true", "bWorldGravitySet = false", ReplayError, "gravity",
    ),
    "gravity upside down": Fault(
        "cpp", "WorldGravityZ = -981.0f", "WorldGravityZ = 981.0f", differs,
    ),
    "time step left to the project": Fault(
        "h", "bool bPinTimeStep = true", "bool bPinTimeStep = false", ReplayError, "time step",
    ),
    "commands after physics": Fault(
        "cpp", "TickGroup = TG_PrePhysics", "TickGroup = TG_PostPhysics", ReplayError, "before physics",
    ),
    "both grounds for everybody": Fault(
        "cpp", "bForWheels ? ECR_Block : ECR_Ignore", "ECR_Block", ReplayError, "either ordinary bodies",
    ),
    "body that ignores vehicles": Fault(
        "cpp", "\tBody->SetCollisionResponseToAllChannels(ECR_Block);\n",
        "\tBody->SetCollisionResponseToAllChannels(ECR_Block);\n"
        "\tBody->SetCollisionResponseToChannel(ECC_Vehicle, ECR_Ignore);\n",
        ReplayError, "does not block",
    ),
    "unknown collision profile": Fault(
        "cpp", 'TEXT("PhysicsActor")', 'TEXT("PhysicsActro")', ReplayError, "collision profile",
    ),
    "hits are not reported": Fault(
        "cpp", "Car1Settings.bReportsHits = true", "Car1Settings.bReportsHits = false", event_lost,
    ),
    "callback bound twice": Fault(
        "cpp", "AddDynamic(this, &AEsgScene_S6Player::OnBodyHit);\n",
        "AddDynamic(this, &AEsgScene_S6Player::OnBodyHit);\n"
        "\t\t\tBody.Component->OnComponentHit.AddDynamic(this, &AEsgScene_S6Player::OnBodyHit);\n",
        ReplayError, "AddDynamic twice",
    ),
    "overlapping placement": Fault(
        "cpp", "TrashBin1Settings.Location = FVector(100.0, -40.0,",
        "TrashBin1Settings.Location = FVector(-560.0, 100.0,",
        overlap_logged,
    ),
    "y not mirrored": Fault(
        "cpp", "Car1Settings.Location = FVector(-600.0, 100.0,", "Car1Settings.Location = FVector(-600.0, -100.0,",
        differs,
    ),
    "heading not mirrored": Fault(
        "cpp", "Car1Drive1.Heading = -11.", "Car1Drive1.Heading = 11.", differs,
    ),
    "metres for centimetres": Fault(
        "cpp", "Car1Drive1.Speed = 600.0", "Car1Drive1.Speed = 6.0", differs,
    ),
    "mass off by a thousand": Fault(
        "cpp", "Car1Settings.Mass = 1200.0f", "Car1Settings.Mass = 1.2f", differs,
    ),
    "drive survives its touch": Fault(
        "cpp", "AddCommand(Car1Mesh, { TrashBin1Mesh })", "AddCommand(Car1Mesh, { Table1Mesh })", differs,
    ),
    "command one step late": Fault(
        "cpp", "SceneTime + EsgScene_S6Detail::HalfStep * Step", "SceneTime - EsgScene_S6Detail::HalfStep * Step",
        differs,
    ),
    "rotation that is no unit quaternion": Fault(
        "cpp", "Table1Settings.Rotation = FQuat(0.0, 0.0, 0.34", "Table1Settings.Rotation = FQuat(0.0, 0.0, 0.84",
        ReplayError, "unit quaternion",
    ),
    "index out of bounds": Fault("cpp", "\tAddCommand(Car1Mesh);\n", "", ReplayError, "bounds"),
}  # fmt: skip


def test_there_are_at_least_twenty_kinds() -> None:
    assert len(FAULTS) >= 20


@pytest.fixture(scope="module")
def folders(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """A folder per fault; all classes are compiled as one batch."""
    root = tmp_path_factory.mktemp("faults")
    out: dict[str, Path] = {}
    for i, (name, fault) in enumerate(FAULTS.items()):
        folder = out[name] = written(root / str(i), *scenes.street(), scenes.STREET_WATCH)
        (emitted,) = read_classes([folder])
        whole = self_contained(emitted)
        for suffix, text in (("h", whole.header), ("cpp", whole.source)):
            if suffix == fault.file:
                assert fault.old in text, f"{name} does not apply: the emitted text has changed"
                text = text.replace(fault.old, fault.new, 1)
            (folder / "unreal" / f"EsgScene_S6.{suffix}").write_text(text)
        vouched(folder)
    compiled = [n for n, f in FAULTS.items() if f.caught is not ClassError]
    compile_many(read_classes(out[n] for n in compiled))
    return out


@pytest.fixture(scope="module")
def right(tmp_path_factory: pytest.TempPathFactory) -> tuple[ClassReplay, Rollout]:
    """The class without a fault, and the program."""
    return both(tmp_path_factory.mktemp("right"), *scenes.street(), scenes.STREET_WATCH)


@pytest.mark.parametrize("name", FAULTS)
def test_fault_is_caught(
    name: str, folders: dict[str, Path], right: tuple[ClassReplay, Rollout]
) -> None:
    fault = FAULTS[name]
    if isinstance(fault.caught, type):
        with pytest.raises(fault.caught, match=fault.says):
            replay_class(folders[name])
    else:
        assert fault.caught(replay_class(folders[name]), right[1])


def test_the_class_without_a_fault_passes_all_checks(right: tuple[ClassReplay, Rollout]) -> None:
    assert not differs(*right) and not overlap_logged(*right) and not event_lost(*right)
