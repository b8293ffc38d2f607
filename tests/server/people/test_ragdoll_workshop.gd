extends TestCase
## Making ragdolls while something else is loaded.

const PERSON: PackedScene = preload("res://scenes/actor/person.tscn")

var _workshop: RagdollWorkshop = null
var _parent: Node3D = Node3D.new()
var _thread: Thread = Thread.new()
var _has_lock: Semaphore = Semaphore.new()
var _is_over: Semaphore = Semaphore.new()


func before_each() -> void:
	_workshop = RagdollWorkshop.new(PERSON, _parent)


func after_each() -> void:
	_workshop.close()
	_parent.free()


func test_nothing_is_made_while_another_thread_loads() -> void:
	_workshop.begin(PersonCard.new(), RagdollMotor.ROOT_SOFT, _start)
	equal(_workshop.next_kind(), &"make")
	_thread.start(_load)
	_has_lock.wait()
	is_false(_workshop.restock(), "the stock waits")
	is_false(_workshop.is_ready(), "who joins waits")
	_workshop.advance()
	equal(_workshop.next_kind(), &"make", "it is left for later, nobody waits")
	_is_over.post()
	_thread.wait_to_finish()
	is_true(_workshop.is_ready())
	_workshop.advance()
	equal(_workshop.next_kind(), &"take")
	is_true(_workshop.restock())


func _start() -> Transform3D:
	return Transform3D.IDENTITY


## What the loader of a level does, in a thread.
func _load() -> void:
	RenderLock.hold()
	_has_lock.post()
	_is_over.wait()
	RenderLock.release()
