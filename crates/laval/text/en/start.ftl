# Start of a motion.

start-undeflected = The motion starts undeflected and is measured from there: { $why }. Displacements include the deflection under load.
