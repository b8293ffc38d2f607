extends CheckSuite
## Life cycle, references, virtuals, notifications and casts.


func run() -> void:
	_references()
	_churn()
	await _nodes()
	_abstract_classes()


func _references() -> void:
	var probe := ValueProbe.new()
	probe.gain = 2.5
	var child := probe.make_child()
	equal("made in C++", [child.get_class(), child.gain], ["ValueProbe", 5.0])
	equal("reference count of a result", child.get_reference_count(), 1)
	equal("alive", ValueProbe.get_alive(), 2)
	equal("same object back", probe.hold(child) == child, true)
	equal("reference held in C++", child.get_reference_count(), 2)
	probe.release()
	equal("reference released in C++", child.get_reference_count(), 1)
	check("null as a reference", probe.hold(null) == null)
	child = null
	equal("freed", ValueProbe.get_alive(), 1)
	var many := probe.make_many(1000)
	equal("many alive", ValueProbe.get_alive(), 1001)
	equal("many in order", many[999].gain, 999.0)
	many.clear()
	equal("many freed", ValueProbe.get_alive(), 1)


func _churn() -> void:
	var probe := ValueProbe.new()
	var node := NodeProbe.new()
	for i in 2000:  # Warm-up, so that the engine's pools have their size.
		_churn_once(probe, node, i)
	var before := OS.get_static_memory_usage()
	for i in 20000:
		_churn_once(probe, node, i)
	var grown := OS.get_static_memory_usage() - before
	check("no leak", grown < 64 * 1024, grown)
	equal("nothing left alive", ValueProbe.get_alive(), 1)
	node.free()


func _churn_once(probe: ValueProbe, node: NodeProbe, i: int) -> void:
	var other := ValueProbe.new()
	other.gain = i
	probe.echo("string %d" % i)
	probe.echo([i, {"key": i}])
	probe.make_many(2)
	probe.hold(other)
	probe.release()
	node.list_children()


func _nodes() -> void:
	var probe := NodeProbe.new()
	equal("child made in a constructor", probe.get_built_in().name, &"BuiltIn")
	var resource := ResourceProbe.new()
	equal("virtual with a result", resource.get_rid().get_id(), 77)
	add_child(probe)
	equal("virtuals", [probe.get_entered(), probe.get_readied()], [1, 1])
	equal("notification", probe.get_notified(), PackedStringArray(["enter"]))
	probe.spawn(4)
	var kinds := probe.get_children().map(probe.kind_of)
	equal("casts", kinds, [1, 2, 3, 4])
	var outside := Marker3D.new()
	equal("cast of an engine class outside the profile", probe.kind_of(outside), 2)
	outside.free()
	equal("cast of nothing", probe.kind_of(null), 0)
	equal("cast of a scripted node", probe.kind_of(self), 1)
	check("identity", probe.is_self(probe) and not probe.is_self(self))
	check("object as a result", probe.child_as_object(1) == probe.get_child(1))
	equal("typed array of nodes", probe.list_children(), probe.get_children())
	check("node by path", probe.find(^"..") == self)
	var loud: LoudNodeProbe = probe.get_child(3)
	equal("inherited virtual", loud.get_readied(), 1)
	equal("inherited notification", loud.get_notified(), PackedStringArray(["enter", "loud enter"]))
	await get_tree().process_frame
	await get_tree().process_frame
	check("_process", loud.get_frames() >= 1, loud.get_frames())
	probe.remove_child(loud)
	var notified := PackedStringArray(["enter", "loud enter", "loud exit", "exit"])
	equal("notification on the way out", loud.get_notified(), notified)
	loud.free()
	var child := probe.get_child(2)
	probe.free()
	check("freed with its parent", not is_instance_valid(child))


func _abstract_classes() -> void:
	check("abstract class", not ClassDB.can_instantiate(&"AbstractProbe"))
	var concrete := ConcreteProbe.new()
	equal("method of an abstract class", concrete.answer(), 42)
	concrete.free()
