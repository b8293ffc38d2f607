extends RefCounted
## Base of the parts of the benchmark: voices and a listener in the tree, and what else a part adds.

var _tree: SceneTree = null
var _report: BenchReport = null
var _voices: SoundVoices = null
var _camera: Camera3D = null
var _nodes: Array[Node] = []


func _init(p_tree: SceneTree, p_report: BenchReport) -> void:
	_tree = p_tree
	_report = p_report


func _begin() -> void:
	_voices = SoundVoices.new()
	_camera = Camera3D.new()
	_add(_camera)
	_add(_voices)
	_voices.listener = _camera


func _end() -> void:
	_voices.stop_all()
	for node: Node in _nodes:
		node.queue_free()
	_nodes.clear()


func _add(p_node: Node) -> void:
	_tree.root.add_child(p_node)
	_nodes.append(p_node)
