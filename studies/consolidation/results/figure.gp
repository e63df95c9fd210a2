set terminal svg size 1080,380 font "Helvetica,13" background rgb "white"
set output "figure.svg"
set datafile separator ","
set multiplot layout 1,3
set border 3
set tics nomirror
set bmargin 6
set key at graph 0.5, graph -0.26 center top maxcols 2 samplen 2
set xlabel "time factor T"
set ylabel "pressure at half of the height / load"
set xrange [0:1]
set yrange [0:1.1]
plot "curves.csv" skip 1 using 1:3 with lines lw 2 lc rgb "#888888" title "Terzaghi", \
     "moments.csv" skip 1 using 1:4 with points pt 7 ps 0.6 lc rgb "#1f5fa8" title "PFV-DEM"
set xlabel "pressure / load"
set ylabel "height / H"
set xrange [0:1.1]
set yrange [0:1]
plot for [i=0:3] "profiles.csv" skip 1 using ($1==word("0.05 0.25 0.50 0.75",i+1)?$4:1/0):2 with lines lw 2 lc rgb "#888888" notitle, \
     for [i=0:3] "profiles.csv" skip 1 using ($1==word("0.05 0.25 0.50 0.75",i+1)?$3:1/0):2 with points pt 7 ps 0.6 lc i+1 title "T = ".word("0.05 0.25 0.50 0.75",i+1)
set xlabel "time factor T"
set ylabel "settlement / final settlement"
set xrange [0:1]
set yrange [1:0]
plot "curves.csv" skip 1 using 1:2 with lines lw 2 lc rgb "#888888" title "Terzaghi", \
     "moments.csv" skip 1 using 1:2 with points pt 7 ps 0.6 lc rgb "#1f5fa8" title "PFV-DEM"
