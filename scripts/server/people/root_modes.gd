class_name RootModes
extends RefCounted
## The values of --root: how a body is held at the position of its motion.

## By their names: grounded people stand on their own feet; inertial finds travel from the feet,
## as a suit without positions needs it.
const BY_NAME: Dictionary[String, RagdollMotor.RootMode] = {
	"grounded": RagdollMotor.ROOT_GROUNDED,
	"soft": RagdollMotor.ROOT_SOFT,
	"held": RagdollMotor.ROOT_HELD,
	"inertial": RagdollMotor.ROOT_INERTIAL,
	"contacts": RagdollMotor.ROOT_CONTACTS,
	"lowest_foot": RagdollMotor.ROOT_LOWEST_FOOT,
	"pendulum": RagdollMotor.ROOT_PENDULUM,
	"self_righting": RagdollMotor.ROOT_SELF_RIGHTING,
}
