class_name ContactScene
extends RefCounted
## A scripted physical scene: makes worlds, plays in them and reports stats.

## The tree that worlds are added to.
var tree: SceneTree = null
## Where stats go.
var report: BenchReport = null
## Ticks a second.
var hz: int = 60
## Who moves the hips.
var root: RagdollMotor.RootMode = RagdollMotor.ROOT_SOFT


## Plays it with somebody.
func play(_performer: ContactPerformer) -> void:
	pass


## A fresh world in the tree.
func make_world() -> ContactWorld:
	var world: ContactWorld = ContactWorld.new(hz)
	tree.root.add_child(world)
	return world


## Frees a world and waits until it is gone.
func end_world(p_world: ContactWorld) -> void:
	for person: ContactPerson in p_world.people:
		# Motions refer to the scene, which refers to the person.
		person.pose = Callable()
		person.place = Callable()
	p_world.queue_free()
	await tree.process_frame


## The name of a case in the report.
func name_case(p_scene: String, p_performer: ContactPerformer) -> String:
	var mode: String = RootModes.BY_NAME.find_key(root)
	return "%s, %s, %s, %d Hz" % [p_scene, p_performer.name, mode, hz]
