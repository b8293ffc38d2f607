class_name ClientContext
extends RefCounted
## What the parts of a client share: who it is, what it shows, where its world comes from, and what
## one part leaves for the others in each frame.

## A notice of the server, or of this program, that the user must see on every display.
signal notified(p_text: String)
## The session is to end with an exit code, such as [constant StateStream.EXIT_DONE].
signal leave_wanted(p_exit_code: int)
## The session cannot go on: an exit code, and why.
signal failed(p_exit_code: int, p_why: String)
## The program is about to start again in this process, and everything open is to be closed.
signal restart_near
## A frame has been drawn, at a time of [method Time.get_ticks_usec].
signal drawn(p_now_usec: int)

## Name of the role, see [ProgramRoles].
var role: String = ""
## The options of the program.
var options: Options = null
## What is shown: level, people, things, camera.
var scene: ClientScene = null
## What the screen says.
var hud: Hud = null
## What the user has chosen before on this machine; null where there is no window.
var settings: UserSettings = null
## What is measured of the session.
var stats: ClientStats = ClientStats.new()
## Where the world comes from.
var stream: StateStream = null
## The connection to the server; null in a client that plays a recording.
var link: ClientLink = null
## The people whose motion this client sends; null where it sends none.
var people: ClientPeople = null
## The user looks at themselves before the session begins; null: it begins at once.
var try_out: TryOut = null
## The user's headset; null without one.
var headset: ClientHeadset = null
## Entries of the window's menu that parts add.
var menu: WindowMenu = null
## Whether the user sits in a vehicle, whose keys those are then.
var is_seated: bool = false
## Which dialogs and menus take the keys while they are open: [code]func() -> bool[/code] each.
var menus: Array[Callable] = []
## Sees a message about the world before it is taken in, and says whether it keeps that message for
## later: [code]func(bytes: PackedByteArray) -> bool[/code]. Not valid: every message is taken in.
var keeper: Callable = Callable()
## How much of the session's first world is there, 0 to 1.
var arrived: float = 0.0
## When the session began, by the clock of [member stream], s.
var begin_s: float = 0.0
## Name of a file to write that no other start of this program has written: see
## [method ClientDisplay.fresh_file].
var fresh_file: Callable = func(p_path: String) -> String: return p_path

## When the present frame will be seen, µs, as far as the display knows; 0: it does not.
var due_usec: int = 0
## The moment that the present frame shows, µs of [method Time.get_ticks_usec].
var frame_usec: int = 0
## Where the bodies of this client's own people are in the present frame, by person: see
## [method WorldReplica.person_floats].
var own_bodies: Dictionary[int, PackedFloat32Array] = {}
## Says which tick of the server is shown, where several machines must agree:
## [code]func(tick: float) -> float[/code]; otherwise not valid.
var agreement: Callable = Callable()
## Where the user's ears are; null: at the camera.
var ears: Node3D = null


## Whether this client's role may do something.
func can(p_capability: Roles.Capability) -> bool:
	return Roles.can(Roles.find(role), p_capability)


## Whether keys now go to a menu or a dialog.
func is_menu_open() -> bool:
	return menus.any(func(is_open: Callable) -> bool: return is_open.call())


## Whether the user looks out of a headset.
func is_headset_worn() -> bool:
	return headset != null and headset.display.is_worn()


## The moment of now on the clock of [member stream], s: of a recording, its own time.
func now_s() -> float:
	return stream.now_s()


## A clock for what has no part in the world's time, such as menus and devices, s: it goes on while
## a recording stands still, is slow or jumps.
static func ui_s() -> float:
	return Time.get_ticks_usec() / 1e6


## Whether nothing is drawn: there is no window.
static func is_headless() -> bool:
	return DisplayServer.get_name() == "headless"


## Takes a message about the state of the world that arrived at a time of the stream's clock, s.
func take(p_bytes: PackedByteArray, p_time_s: float = 0.0) -> void:
	scene.replica.take(p_bytes, p_time_s)
	stats.snapshots = scene.replica.datagrams
