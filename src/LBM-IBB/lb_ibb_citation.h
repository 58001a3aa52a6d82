/* -*- c++ -*- ----------------------------------------------------------
   LAMMPS - Large-scale Atomic/Molecular Massively Parallel Simulator
   https://www.lammps.org/, Sandia National Laboratories
   LAMMPS development team: developers@lammps.org

   This software is distributed under the GNU General Public License,
   version 2.

   See the README file in the top-level LAMMPS directory.
------------------------------------------------------------------------- */

// What every style of the package asks to be cited, once.

#ifndef LMP_LB_IBB_CITATION_H
#define LMP_LB_IBB_CITATION_H

namespace LAMMPS_NS {

inline const char LB_IBB_CITATION[] =
    "LBM-IBB package: https://doi.org/10.1002/nag.2556\n\n"
    "@Article{Mansouri2016,\n"
    " author =  {Mansouri, Mouloud and El Youssoufi, Moulay Sa{\\\"i}d and Nicot, Fran{\\c "
    "c}ois},\n"
    " title =   {Numerical simulation of the quicksand phenomenon by a {3D} coupled\n"
    "            {Discrete Element - Lattice Boltzmann} hydromechanical model},\n"
    " journal = {International Journal for Numerical and Analytical Methods in Geomechanics},\n"
    " year =    {2016},\n"
    " note =    {in print 2017},\n"
    " volume =  {41},\n"
    " number =  {3},\n"
    " pages =   {338--358}\n"
    "}\n\n";

}    // namespace LAMMPS_NS
#endif
