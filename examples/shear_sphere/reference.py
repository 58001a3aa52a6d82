"""Spin of a small free sphere of radius a half-way between walls a distance H apart, periodic by L along both:
omega/shear = 1/2 - c (a/L)^3.

The sphere disturbs the shear as a stresslet, S = (20/3) pi mu a^3 E (Batchelor, J. Fluid Mech. 41, 545 (1970)).
c is the vorticity at its place of the stresslets of its images and of the walls' answer to all of them:
  images  the field -(5/2) a^3 x (x.E.x)/r^5 of each gives -(5/4) (a^3/r^3) (x/r)^2 shear; the sum over a square
          lattice of 1/r^3 is 9.0336
  walls   Stokes flow with no slip at z = +-H/2, Fourier series along x and y; the mean flow (k = 0) apart
"""
from math import cosh, exp, pi, sinh, sqrt


def coefficient(ratio=1.0):
    """c for H/L = ratio"""
    total = -1.25 * 0.5 * 9.0336 + 5 * pi / (3 * ratio)
    for i in range(-12, 13):
        for j in range(-12, 13):
            if i or j:
                k = 2 * pi * sqrt(i * i + j * j)                    # in units of 1/L
                q = 0.5 * k * ratio
                if q < 40:
                    walls = 2 * (cosh(q) * exp(-q) - q) / (cosh(q) * sinh(q) + q) + exp(-q) / sinh(q)
                    total += 10 * pi / 24 * k * walls
    return -total


if __name__ == "__main__":
    for ratio in 0.5, 1.0, 2.0:
        print(f"H/L = {ratio}: omega/shear = 1/2 - {coefficient(ratio):.4f} (a/L)^3")
