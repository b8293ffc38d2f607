@abstract class_name SeatAuthority
extends EntityAuthority
## What a [Seat] needs from the program that decides what is true, besides what its [Entity] does.

## Who possesses what.
@abstract func possession() -> Possession

## Carries the people of a session in a seat of an entity from now on.
@abstract func attach(p_session: int, p_entity: int, p_seat: SeatGeometry) -> void

## Ends what [method attach] began.
@abstract func detach(p_session: int) -> void
