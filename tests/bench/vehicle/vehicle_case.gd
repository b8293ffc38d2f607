class_name VehicleCase
extends RefCounted
## A part of the benchmark of vehicles: what all of them are given.

## The tree that worlds are added to.
var tree: SceneTree = null
## Where values go.
var report: BenchReport = null
## The vehicle: tank, carrier, truck or scootmobile.
var preset: String = "tank"
## The running gear by its name, and as what it is.
var gear: String = "spheres"
var kind: VehicleParameters.GearKind = VehicleParameters.GearKind.SPHERES
## Of simulated driving, for cases that take long.
var minutes: float = 1.0


## Measures, and adds values to the report.
func run() -> void:
	pass
