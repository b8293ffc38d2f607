class_name Impact
extends RefCounted
## Something strikes something, or slides along it: what is to be heard of a contact of two bodies.

## [member other] where it is nothing that the server calls an entity, such as the ground.
const NO_ENTITY: int = 0xffff

## The server's tick at which it happens.
var tick: int = 0
## Number of the entity that strikes.
var entity: int = 0
## Number of the entity that is struck, or [constant NO_ENTITY].
var other: int = NO_ENTITY
## Where, in the world, m.
var place: Vector3 = Vector3.ZERO
## Impulse along the normal, N·s; of a scrape, within one tick.
var impulse: float = 0.0
## How fast the surfaces slide over one another, m/s; 0 for an impact, more for a scrape.
var slip: float = 0.0
## What the entity is made of, and what it strikes: numbers of contact materials.
var material: int = 0
var other_material: int = 0


## Whether it is a scrape: of one that lasts there is news each tenth of a second. A datagram may
## be lost, so that clients let it fade when there was none for longer.
func is_scrape() -> bool:
	return slip > 0.0
