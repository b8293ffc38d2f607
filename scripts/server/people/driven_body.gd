class_name DrivenBody
extends RefCounted
## A body that follows a wearer's motion, wherever it stands, sits or is carried.

## The body.
var ragdoll: Ragdoll = null
## The newest sample, or null.
var newest: PoseSample = null
## Position of the person's own origin in the frame of its motor, m.
var origin: Vector3 = Vector3.ZERO
## Scales the wearer's travel to the body's build.
var scale: float = 1.0


## Begins the motion anew at a start position: the wearer's own frame is turned there.
func stand_at(p_start: Transform3D) -> void:
	var turn: Basis = p_start.basis
	origin = p_start.origin
	ragdoll.motor.set_frame(Transform3D(turn, p_start.origin - turn * p_start.origin))
	ragdoll.motor.clear_motion()


## Where the body's hips are, m.
func hips() -> Vector3:
	return ragdoll.get_hips()
