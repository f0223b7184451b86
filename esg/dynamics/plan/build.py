"""From a laid-out ESG (cm, degrees) to the physical scene (SI): the border of the simulator."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from esg.assets.drawn_parts import drawn_parts
from esg.assets.gestures import gestures_of
from esg.assets.shows import plumes_of, shines_of, sways_of, weather_of_scene
from esg.dynamics.plan.fragments import with_fragments
from esg.dynamics.plan.joints import joints_of
from esg.dynamics.plan.postures import with_postures
from esg.dynamics.plan.tyres import with_tyres
from esg.engines.scene import Body, Region, Shape, SimScene, Wheel
from esg.graph.casting import effective
from esg.graph.models import AssetConfiguration, EsgDocument, Node, Pose, Proxy, ProxyKind, Role
from esg.outcomes import UserError
from esg.units import quat_from_euler_deg, quat_rotate

_GROUND_CATEGORIES = ("ground", "floor", "grass", "pavement", "street", "road", "lawn", "field")


def build_scene(doc: EsgDocument) -> SimScene:
    """Builds the bodies, regions and materials of a laid-out document.

    Args:
        doc: A document with `asset_configurations` and `layout_result`.

    Returns:
        The scene in SI, bodies in the order of the graph's nodes.

    Raises:
        UserError: If a stage before this one has not run.
    """
    doc = effective(doc)
    if doc.layout_result is None:
        raise UserError("the document has no layout_result: run the layout stage first")
    nodes = doc.spatial_relation_graph.nodes
    missing = [n for n in nodes if nodes[n].asset_id not in doc.asset_configurations]
    if missing:
        raise UserError(f"nodes {missing} have no asset configuration: run the resolve stage first")
    actors = doc.timeline_system.actors if doc.timeline_system else {}
    starts = doc.dynamics_result.start_poses if doc.dynamics_result else {}
    drawn, shines, sways = drawn_parts(doc), shines_of(doc), sways_of(doc)
    gestures, plumes = gestures_of(doc), plumes_of(doc)
    bodies: list[Body] = []
    regions: list[Region] = []
    friction, restitution = 0.7, 0.3
    for name, node in nodes.items():
        config = doc.asset_configurations[node.asset_id]
        pose = starts.get(name) or doc.layout_result.poses[name]
        role = actors[name].role if name in actors else Role.PASSIVE
        body = make_body(doc, name, node, config, pose, active=role is Role.ACTIVE)
        body = replace(body, drawn=drawn[name]) if name in drawn else body
        if name in shines or name in sways:
            body = replace(body, shines=shines.get(name, ()), sways=sways.get(name))
        if name in gestures:
            body = replace(body, gestures=gestures[name])
        if name in plumes:
            body = replace(body, gives_off=plumes[name])
        bodies.append(body)
        com = np.array(config.center_of_mass_cm)
        for region in config.regions:
            regions.append(
                Region(
                    name=f"{name}/{region.name}",
                    parent=name,
                    center=_vec((np.array(region.center_cm) - com) / 100.0),
                    half_extents=_vec(np.array(region.half_extents_cm) / 100.0),
                    kind=region.kind,
                )
            )
        if node.is_structural and not config.proxies and config.category in _GROUND_CATEGORIES:
            friction, restitution = config.friction, config.restitution
    scene = SimScene(
        scene_id=doc.scene_definition.scene_id,
        bodies=tuple(bodies),
        regions=tuple(regions),
        ground_friction=friction,
        ground_restitution=restitution,
        joints=joints_of(doc, bodies),
        weather=weather_of_scene(doc),
    )
    return with_postures(doc, with_fragments(doc, with_tyres(doc, scene)))


def make_body(
    doc: EsgDocument,
    name: str,
    node: Node,
    config: AssetConfiguration,
    pose: Pose,
    *,
    active: bool,
) -> Body:
    """One node as a rigid body whose frame has its origin at the centre of mass."""
    requirement = doc.asset_requirement.get(node.asset_id)
    com = np.array(config.center_of_mass_cm)
    quaternion = quat_from_euler_deg(pose.yaw_deg, pose.pitch_deg, pose.roll_deg)
    position = (np.array(pose.position_cm) + quat_rotate(quaternion, com)) / 100.0
    ixx, iyy, izz, ixy, ixz, iyz = (v * 1e-4 for v in config.inertia_kg_cm2)
    half = np.array(config.dimensions_cm) / 200.0
    return Body(
        name=name,
        static=node.is_structural or node.is_static or not config.is_movable,
        mass=config.mass_kg,
        inertia=((ixx, ixy, ixz), (ixy, iyy, iyz), (ixz, iyz, izz)),
        shapes=tuple(_shape(p, com) for p in config.proxies),
        position=_vec(position),
        quaternion=tuple(float(v) for v in quaternion),  # type: ignore[arg-type]  # length is 4
        friction=config.friction,
        restitution=config.restitution,
        linear_damping=config.linear_damping,
        angular_damping=config.angular_damping,
        wheeled=config.is_wheeled,
        roll_radius=float(half[2]) if config.rolls else 0.0,
        origin_offset=_vec(-com / 100.0),
        half_extents=_vec(half),
        mesh=config.mesh_path,
        category=config.category,
        label=node.label,
        description=requirement.asset_description if requirement else config.asset_name,
        color=config.color_rgb,
        group=node.group or "",
        mentioned=node.mentioned,
        active=active,
        turned=None if config.lying is None else config.lying.turned_xyzw,
        wheels=tuple(
            Wheel(w.name, _vec((np.array(w.axle_cm) - com) / 100.0), w.radius_cm / 100.0)
            for w in config.wheels or ()
        ),
    )


def _shape(proxy: Proxy, com: np.ndarray) -> Shape:
    kinds = {k: k.value for k in ProxyKind}
    return Shape(
        kind=kinds[proxy.kind],  # type: ignore[arg-type]  # the enum's values are the literals
        size=_vec(np.array(proxy.size_cm) / 100.0),
        position=_vec((np.array(proxy.position_cm) - com) / 100.0),
        quaternion=proxy.orientation_xyzw,
        vertices=tuple(_vec(np.array(v) / 100.0) for v in proxy.vertices_cm),
    )


def _vec(v: np.ndarray) -> tuple[float, float, float]:
    return (float(v[0]), float(v[1]), float(v[2]))
