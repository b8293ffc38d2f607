class_name VehicleState
extends RefCounted
## What everybody knows of a vehicle besides where its body is.
##
## The server's simulation makes it, replication carries it as fields, the visualizer, the motion
## platform and the instruments read it.

## Whether a vehicle still works.
enum Damage {
	## Nothing is broken.
	WHOLE,
	## It is hit and still drives.
	DAMAGED,
	## It burns or is knocked out.
	KNOCKED_OUT,
}

## Speed of the engine, 1/min.
var rpm: float = 0.0
## Share of the engine's full torque that is called for, 0 to 1.
@warning_ignore("shadowed_global_identifier") var load: float = 0.0
## The gear that is in: 1 and up forward, -1 and down reverse, 0 none.
var gear: int = 0
## Speed of the left track, or mean of the left wheels, over the ground that they roll on, m/s;
## forward is positive.
var left_speed: float = 0.0
## The same on the right, m/s.
var right_speed: float = 0.0
## Where the turret points from ahead, rad, anticlockwise seen from above (about +Y).
var turret_yaw: float = 0.0
## Elevation of the gun above the hull's plane, rad; up is positive.
var gun_pitch: float = 0.0
## Whether the gun is stabilised: the aim is held in the world.
var stabilised: bool = true
## The commander's hatch: 0 shut, 1 open.
var hatch: float = 0.0
## The loader's hatch: 0 shut, 1 open.
var loader_hatch: float = 0.0
## Angle of the steered wheels, rad, to the left is positive; of vehicles with wheels only.
var steer: float = 0.0
## How far the brake is pressed, 0 to 1.
var brake: float = 0.0
## Whether the lamps are on.
var lamps: bool = false
## Whether it still works.
var damage: Damage = Damage.WHOLE
## Whether the engine runs.
var engine_on: bool = false
