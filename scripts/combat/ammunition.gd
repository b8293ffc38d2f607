@tool
@icon("res://scenes/combat/icons/ammunition.svg")
class_name Ammunition
extends Resource
## One kind of round: what leaves the muzzle, how it flies, and what it does where it hits.

## What it works by.
enum Kind {
	## Its mass and speed: a dart.
	KINETIC,
	## Its charge: it bursts where it hits.
	HIGH_EXPLOSIVE,
	## The bullet of a machine gun: many of them, each of which does little.
	BULLET,
}

## What people call it.
@export var title: String = ""
## What it works by.
@export var kind: Kind = Kind.KINETIC

@export_group("Round")
## Mass of what flies to the target, kg.
@export_range(0.001, 100.0, 0.001, "suffix:kg") var mass: float = 4.6
## Mass of what leaves the muzzle besides and falls off, kg.
@export_range(0.0, 20.0, 0.1, "suffix:kg") var sabot_mass: float = 0.0
## Mass of the propellant, kg: its gas gives a large part of the recoil.
@export_range(0.0, 30.0, 0.001, "suffix:kg") var propellant_mass: float = 0.0
## Mean speed of that gas as it leaves the muzzle, m/s.
@export_range(0.0, 2500.0, 10.0, "suffix:m/s") var gas_speed: float = 1400.0
## Speed at the muzzle, m/s.
@export_range(10.0, 2500.0, 1.0, "suffix:m/s") var muzzle_speed: float = 1650.0
## Calibre of what flies, m.
@export_range(0.001, 0.5, 0.0001, "suffix:m") var calibre: float = 0.12

@export_group("Flight")
## Drag coefficient, which does not change with the speed; of shells. Not used where there is a
## ballistic coefficient.
@export_range(0.0, 2.0, 0.01) var drag_coefficient: float = 0.4
## Ballistic coefficient for the G7 standard, lb/in^2, as it is published; of bullets. 0: none.
@export_range(0.0, 2.0, 0.001, "suffix:lb/in²") var ballistic_coefficient: float = 0.0
## Whether it can be seen in flight.
@export var has_tracer: bool = true

@export_group("Hit")
## Factor on the momentum that it gives to what it hits: a bullet's true momentum would move nobody.
@export_range(0.0, 20.0, 0.1) var impulse_factor: float = 1.0
## Thickness of steel that it pierces at the muzzle's speed, mm.
@export_range(0.0, 2000.0, 1.0, "suffix:mm") var penetration: float = 470.0
## Radius of its blast, m; 0: it does not burst.
@export_range(0.0, 100.0, 0.5, "suffix:m") var blast_radius: float = 0.0
## Impulse of its blast on a square metre that faces it at a distance of 1 m, N s.
@export_range(0.0, 20000.0, 10.0, "suffix:N s") var blast_impulse: float = 0.0
## Thickness of steel that its fragments pierce within half of the blast's radius, mm.
@export_range(0.0, 200.0, 1.0, "suffix:mm") var fragment_penetration: float = 0.0


## A flight of it, not yet fired; null where its values make no sense.
func make_flight() -> ShellFlight:
	if find_fault() != "":
		return null
	var flight: ShellFlight = ShellFlight.new()
	if ballistic_coefficient > 0.0:
		flight.set_ballistic_coefficient(ballistic_coefficient)
	else:
		flight.set_drag(drag_coefficient, calibre, mass)
	return flight


## Impulse of a shot on the gun (recoil), N s.
func recoil() -> float:
	return (mass + sabot_mass) * muzzle_speed + propellant_mass * gas_speed


## Thickness of steel that it pierces at a speed (m/s), mm. A hollow charge pierces the same at any
## speed.
func penetration_at(p_speed: float) -> float:
	if kind == Kind.HIGH_EXPLOSIVE:
		return penetration
	var share: float = p_speed / muzzle_speed
	return penetration * share * share


## Why it cannot be fired, or an empty text.
func find_fault() -> String:
	for name: StringName in [&"mass", &"muzzle_speed", &"calibre"]:
		if not (is_finite(get(name)) and get(name) > 0.0):
			return "%s is %s, it must be above 0" % [name, get(name)]
	for name: StringName in [
		&"sabot_mass",
		&"propellant_mass",
		&"gas_speed",
		&"drag_coefficient",
		&"ballistic_coefficient",
		&"impulse_factor",
		&"penetration",
		&"blast_radius",
		&"blast_impulse",
		&"fragment_penetration",
	]:
		if not (is_finite(get(name)) and get(name) >= 0.0):
			return "%s is %s, it must not be below 0" % [name, get(name)]
	return ""
